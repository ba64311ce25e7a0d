// JupyterLab says "Error displaying widget: model not found" for every view of a notebook that is opened anew. The output holds
// more than that view: its picture or its text, which this shows instead, and says what to do. It also gives pictures their texts,
// and keeps the words of outputs whole, which JupyterLab breaks anywhere at the end of a line.
(() => {
  const WIDGET = "application/vnd.jupyter.widget-view+json";
  const FAILED = /^Error displaying widget/;
  const SETTLED_MS = 700;
  const LOOKS = 20;
  const NOTE = "Not running now: this is how it looked. Run the cell to have it live.";

  function outputOf(app, node) {
    for (const panel of app.shell.widgets("main")) {
      const cell = panel.node.contains(node) && panel.content?.widgets?.find((one) => one.node.contains(node));
      const area = cell && cell.outputArea;
      const index = area ? area.widgets.findIndex((one) => one.node.contains(node)) : -1;
      if (index >= 0) return area.model.get(index);
    }
    return null;
  }

  const textOf = (data) => [data["text/plain"] ?? ""].flat().join("");

  function figure(data) {
    const box = document.createElement("div");
    box.className = "ck-still";
    const note = document.createElement("div");
    note.textContent = NOTE;
    note.style.cssText = "display: inline-block; font: 600 13px/1.5 var(--jp-ui-font-family, system-ui, sans-serif); color: #26323b;"
      + "background: #fff3c4; border: 1px solid #e0c46c; border-radius: 8px; padding: 2px 12px; margin: 4px 0;";
    box.append(note);
    const kind = ["image/png", "image/jpeg"].find((one) => data[one]);
    const shown = document.createElement(kind ? "img" : "pre");
    const text = textOf(data);
    if (kind) {
      Object.assign(shown, { src: `data:${kind};base64,${[data[kind]].flat().join("").trim()}`, alt: text });
      shown.style.cssText = "display: block; max-width: 100%; opacity: 0.8;";
    } else {
      shown.textContent = text;
      shown.style.opacity = "0.7";
    }
    box.append(shown);
    return box;
  }

  // A picture's text, for those who cannot see it: the output has one beside it.
  function describe(app, node) {
    const picture = node.querySelector("img:not([alt])");
    const data = picture && outputOf(app, node)?.data;
    if (data) picture.alt = textOf(data) || "a picture";
  }

  function mend(app, node) {
    describe(app, node);
    if (!FAILED.test(node.textContent) || node.querySelector(".ck-still")) return;
    const data = outputOf(app, node)?.data;
    if (data?.[WIDGET]) node.replaceChildren(figure(data));
  }

  function tellWhenClosed(app, panel, closed) {
    const look = () => {
      if (panel.isAttached) return;
      app.shell.layoutModified.disconnect(look);
      closed();
    };
    app.shell.layoutModified.connect(look);
  }

  // A desk whose kernel was restarted goes when the next one opens; what is closed by hand is told.
  function keepDesks(app, { el, closed }) {
    for (const panel of [...app.shell.widgets("main")]) {
      if (panel.node.contains(el)) tellWhenClosed(app, panel, closed);
      else if (panel.node.querySelector(".ck-floor > .ck-veil")) panel.dispose();
    }
  }

  // A toolbar can miss a change of its width where two follow each other. What no longer fits then lies on the notebook.
  // On a busy computer the width of a desk with a viewer settles late: toolbars are looked at again for a while.
  let nextLook = 0;
  function fitToolbars(app, looks = LOOKS) {
    clearTimeout(nextLook);
    for (const { toolbar } of app.shell.widgets("main")) {
      if (toolbar?.isVisible && (looks === LOOKS || toolbar.node.scrollHeight > toolbar.node.clientHeight + 2)) {
        toolbar.hide();
        toolbar.show();
      }
    }
    if (looks) nextLook = setTimeout(() => fitToolbars(app, looks - 1), SETTLED_MS);
  }

  function keepWordsWhole() {
    const style = document.createElement("style");
    style.textContent = ".jp-OutputArea .jp-OutputArea-output.jp-RenderedText pre { word-break: normal; overflow-wrap: anywhere; }";
    document.head.append(style);
  }

  function activate(app) {
    keepWordsWhole();
    document.addEventListener("coursekit-desk", ({ detail }) => {
      keepDesks(app, detail);
      clearTimeout(nextLook);
      nextLook = setTimeout(() => fitToolbars(app), SETTLED_MS);
    });
    const look = (root) => root.querySelectorAll?.(".jp-OutputArea-output").forEach((node) => mend(app, node));
    new MutationObserver((changes) => {
      for (const { target } of changes) {
        const output = target.nodeType === Node.ELEMENT_NODE ? target.closest(".jp-OutputArea-output") : null;
        if (output) mend(app, output); else look(target);
      }
    }).observe(document.body, { childList: true, subtree: true });
  }

  const plugin = { id: "coursekit-stills:plugin", autoStart: true, activate };
  const shelf = (window._JUPYTERLAB = window._JUPYTERLAB || {});
  shelf["coursekit-stills"] = { init: () => {}, get: async () => () => ({ __esModule: true, default: plugin }) };
})();
