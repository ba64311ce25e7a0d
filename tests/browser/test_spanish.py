"""A course in Spanish, in a real browser: panels and checks speak it, too."""

import pytest

from coursekit.words.gettext import LANGUAGE

from .pages import lab_in

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

CELLS = (
    "from coursekit.lab import *\nimport ipywidgets\nfull_name = lambda *_: 'x'",
    "ipywidgets.VBox([viewer(displays=['Grid'], height=240), timeline(), pad()])",
    "%ros2 run turtlesim turtlesim_node &\nipywidgets.VBox([topic_panel(), log_console(), graph(live=True)])",
    "check('ch02.q1')",
)


@pytest.fixture(scope="module")
def lab(tmp_path_factory, browser):
    """A lab whose course is in Spanish."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(LANGUAGE, "es")
        with lab_in(tmp_path_factory.mktemp("lab"), 77) as served:
            yield served


def test_panels_and_a_check_in_spanish(notebook, picture):
    opened = notebook(*CELLS, width=1100, height=1900)
    opened.run()
    page = opened.page
    words = {
        ".ck-viewer": ("Visor", "Vista inicial", "Agregar", "Vistas"),
        ".ck-timeline": ("Línea de tiempo", "En vivo", "ahora"),
        ".ck-pad": ("haz clic aquí, luego flechas o WASD",),
        ".ck-topics": ("Tópicos", "/turtle1/pose"),
        ".ck-log": ("Registro", "Pausa", "Limpiar"),
        ".ck-graph": ("Grafo", "Nodos y tópicos activos", "servicios"),
    }
    for panel, said in words.items():
        for word in said:
            page.locator(panel).filter(has_text=word).first.wait_for(timeout=30_000)
    shown = page.locator(".jp-OutputArea").filter(has_text="ch02.q1").last.inner_text()
    assert "Nombres en el grafo" in shown
    assert "de 1 punto" in shown and "esperado" in shown and "diste" in shown
    assert "aún no está resuelto; las líneas de arriba dicen qué falta" in shown
    picture(page, "spanish")
