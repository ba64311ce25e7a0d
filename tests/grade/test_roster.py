"""The names of a class, and whose a submission is."""

import pytest

from coursekit.grade.identifying import named_in
from coursekit.grade.roster import Roster


def read(tmp_path, name, text):
    file = tmp_path / name
    file.write_text(text, encoding="utf-8")
    return Roster.read(file).students


def test_names_stand_on_lines_or_in_a_table(tmp_path):
    assert read(tmp_path, "a.txt", "Ann Lee\n\n  Núria O'Neill \n") == ["Ann Lee", "Núria O'Neill"]
    table = '\ufeffID,Student,Mark\n7,"Lee, Ann",\n8,Ben Ito,3\n'
    assert read(tmp_path, "a.csv", table) == ["Ann Lee", "Ben Ito"]
    assert read(tmp_path, "b.csv", "Ann Lee,7\nBen Ito,8\n") == ["Ann Lee", "Ben Ito"]


def test_no_names_and_equal_names_are_told(tmp_path):
    with pytest.raises(ValueError, match="There are no names"):
        read(tmp_path, "a.txt", "\n")
    with pytest.raises(ValueError, match="same name: Ann Lee, ann lee"):
        read(tmp_path, "a.txt", "Ann Lee\nann lee\n")


@pytest.mark.parametrize(
    "file", ["ann lee", "AnnLee_03_services", "annlee_12345_67890_AnnLee_03_services-1", "Lee_Ann Lee_s3"]
)
def test_a_student_is_known_by_the_name_of_what_was_handed_in(file):
    assert named_in(file, Roster(["Ann Lee", "Ben Ito"])) == "Ann Lee"
    assert named_in(file, Roster(["Ben Ito"])) == ""


@pytest.mark.parametrize(
    "headings",
    [
        "First name,Last name,ID number,Email address",
        "Vorname,Nachname,ID-Nummer,E-Mail-Adresse",
        "Prénom,Nom de famille,Numéro d’identification,Adresse de courriel",
        "Nombre,Apellido(s),Número de ID,Dirección de correo",
        "Nome,Cognome,Codice identificativo,Indirizzo email",
    ],
)
def test_moodle_s_list_is_read_in_other_languages_and_it_is_said_how(tmp_path, headings):
    file = tmp_path / "roster.csv"
    file.write_text(f"{headings}\nAna,García López,a01,ana@uni.example\nAna,Ito,a02,ito@uni.example\n", encoding="utf-8")
    roster = Roster.read(file)
    first = roster.people[0]
    assert (first.name, first.id, first.email) == ("Ana García López", "a01", "ana@uni.example")
    assert roster.layout is not None and roster.layout.platform == "moodle"
    assert roster.told().startswith("2 students; ") and roster.told().count("'") >= 8
