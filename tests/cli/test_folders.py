"""``flexure check`` of folders: what it takes, what it passes over, in how many processes."""

import json

import pytest

GOOD = """\
flexure: 1
title: a leaf spring
material: {youngs_modulus: 114 GPa, poisson_ratio: 0.33}
geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: 0.3 mm, l: 10 mm, b: 2 mm}
requirements: {stiffness: {min: 0.1 N*m/rad}}
"""
FAILS = GOOD.replace("min: 0.1 N", "min: 100 N")
FREE = GOOD.replace("h: 0.3 mm", "h: free")
CHECK = ("check", "--model", "source")


@pytest.fixture
def folder(tmp_path):
    files = {
        "a.yaml": GOOD,
        "deep/b.yml": GOOD,
        "deep/material.yaml": "flexure: 1\nmaterial: {youngs_modulus: 114 GPa}\n",
        "deep/ci.yaml": "name: tests\non: [push]\n",
        "deep/list.yaml": "- 1\n- 2\n",
        "deep/two.yaml": "kind: A\n---\nkind: B\n",
        ".venv/c.yaml": GOOD,
        "notes.txt": "flexure: 1\n",
    }
    for name, text in files.items():
        (tmp_path / "specs" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "specs" / name).write_text(text)
    return tmp_path / "specs"


def document(run):
    return json.loads(run.stdout)


def test_a_folder_is_told_file_by_file(flexure, folder):
    told = flexure(*CHECK, "specs", "--format", "json")
    found = document(told)
    assert told.returncode == 0
    assert [r["spec"] for r in found["results"]] == ["specs/a.yaml", "specs/deep/b.yml"]
    why = {row["spec"]: row["why"] for row in found["passed_over"]}
    assert set(why) == {
        "specs/.venv",
        "specs/deep/ci.yaml",
        "specs/deep/list.yaml",
        "specs/deep/material.yaml",
        "specs/deep/two.yaml",
    }
    assert "kind material" in why["specs/deep/material.yaml"]
    assert "'name', not 'flexure'" in why["specs/deep/ci.yaml"]
    text = flexure(*CHECK, "specs").stdout
    assert all(name in text for name in (*why, "specs/a.yaml", "specs/deep/b.yml"))


@pytest.mark.parametrize(
    ("text", "what"),
    [
        (GOOD.replace("flexure:", "flexur:"), "did you mean 'flexure'"),
        (GOOD.replace("flexure:", "Flexure:"), "did you mean 'flexure'"),
        ("flexur: 1\n", "'flexure' is missing"),
        (GOOD.replace("flexure: 1\n", ""), "'flexure' is missing"),
        (GOOD.replace("flexure: 1\n", "version: 1\n"), "'flexure' is missing"),
        ("flexure: 1\n", "'geometry' is missing"),
        (GOOD.replace("flexure: 1", "flexure 1"), ""),
        (GOOD.replace("mm}", "mm"), "never closed"),
    ],
)
def test_a_spec_with_a_mistake_at_its_head_is_a_finding(flexure, folder, text, what):
    (folder / "wrong.yaml").write_text(text)
    told = flexure(*CHECK, "specs")
    assert told.returncode == 2
    assert "specs/wrong.yaml" in told.stderr
    assert what in told.stderr


def test_a_folder_without_a_design_is_no_success(flexure, folder):
    for path in ("a.yaml", "deep/b.yml"):
        (folder / path).unlink()
    told = flexure(*CHECK, "specs", "--format", "json")
    assert told.returncode == 2
    assert (
        document(told)["results"][0]["findings"][0]["text"] == "there is no design in this folder"
    )
    assert len(document(told)["passed_over"]) == 5


def test_free_designs_are_sized_or_skipped_with_a_word(flexure, folder):
    (folder / "free.yaml").write_text(FREE)
    found = document(flexure(*CHECK, "specs", "--format", "json"))
    (sized,) = (r for r in found["results"] if r["spec"] == "specs/free.yaml")
    assert sized["warnings"][0]["code"] == "sized-first"
    told = flexure(*CHECK, "specs", "--free", "skip", "--format", "json")
    assert told.returncode == 0
    (why,) = (r["why"] for r in document(told)["passed_over"] if r["spec"] == "specs/free.yaml")
    assert "h free" in why
    assert flexure(*CHECK, "specs/free.yaml", "--free", "skip").returncode == 2, (
        "nothing was judged"
    )


def test_fail_fast_stops_at_the_first_that_does_not_pass_and_names_the_rest(flexure, folder):
    (folder / "aa.yaml").write_text(FAILS)
    told = flexure(*CHECK, "specs", "--fail-fast", "--format", "json")
    assert told.returncode == 1
    assert [r["status"] for r in document(told)["results"]] == ["pass", "fail"]
    why = {row["spec"]: row["why"] for row in document(told)["passed_over"]}
    assert "specs/aa.yaml did not pass" in why["specs/deep/b.yml"]


def test_quiet_prints_what_does_not_pass_alone(flexure, folder):
    silent = flexure(*CHECK, "specs", "-q")
    assert (silent.returncode, silent.stdout, silent.stderr) == (0, "", "")
    (folder / "aa.yaml").write_text(FAILS)
    told = flexure(*CHECK, "specs", "-q")
    assert told.returncode == 1
    assert "specs/aa.yaml" in told.stdout
    assert "specs/a.yaml" not in told.stdout


@pytest.mark.slow
def test_processes_change_no_answer_and_no_order(flexure, folder):
    (folder / "aa.yaml").write_text(FAILS)
    (folder / "wrong.yaml").write_text("flexure: 1\n")

    def told(*more):
        run = flexure(
            *CHECK, "specs", "--set", "material.density=4 g/cm^3", *more, "--format", "json"
        )
        rows = [
            (r["spec"], r["status"], [c["factor"] for c in r["checks"]], r["findings"])
            for r in document(run)["results"]
        ]
        return run.returncode, rows

    assert told("--jobs", "2") == told("--jobs", "1")


@pytest.mark.slow
def test_a_process_keeps_to_what_the_command_line_allows(flexure, folder):
    """A reference outside the folder is refused, or allowed, in every process alike."""
    (folder.parent / "outside.yaml").write_text(
        "flexure: 1\nmaterial: {youngs_modulus: 114 GPa, poisson_ratio: 0.33}\n"
    )
    (folder / "a.yaml").write_text(
        GOOD.replace("{youngs_modulus: 114 GPa, poisson_ratio: 0.33}", "../outside.yaml")
    )
    assert flexure(*CHECK, "specs", "--jobs", "2").returncode == 2
    assert flexure(*CHECK, "specs", "--jobs", "2", "--allow-outside").returncode == 0


def test_a_linked_file_that_leads_outside_is_passed_over_unless_it_is_allowed(flexure, folder):
    """Nothing of what stands there is told."""
    (folder.parent / "secret.yaml").write_text(FAILS)
    (folder / "link.yaml").symlink_to("../secret.yaml")
    (folder / "own.yaml").symlink_to("a.yaml")
    found = document(flexure(*CHECK, "specs", "--format", "json"))
    (why,) = (r["why"] for r in found["passed_over"] if r["spec"] == "specs/link.yaml")
    assert "outside" in why
    assert "specs/own.yaml" in [r["spec"] for r in found["results"]]
    told = flexure(*CHECK, "specs", "--allow-outside", "--format", "json")
    assert told.returncode == 1
    assert "specs/link.yaml" in [r["spec"] for r in document(told)["results"]]


@pytest.mark.parametrize("style", ["junit", "sarif", "github", "markdown"])
def test_every_format_names_what_was_passed_over_and_why(flexure, folder, style):
    (folder.parent / "outside.yaml").write_text(GOOD)
    told = flexure(*CHECK, "specs", "--format", style)
    assert told.returncode == 0
    assert "passed over" in told.stdout
    for name, why in (("ci.yaml", "its first key is"), ("material.yaml", "of kind material")):
        assert f"specs/deep/{name}" in told.stdout
        assert why in told.stdout
