"""The code that a job depends on."""

from planar_pushing.study.running.dependencies import code_of, modules


def test_a_builder_does_not_depend_on_another():
    reached = modules("study.datasets.contact_modes", "study.slices", "study.storage.store")
    datasets = {name for name in reached if name.startswith("planar_pushing.study.datasets.")}
    assert datasets == {
        f"planar_pushing.study.datasets.{name}" for name in ("base", "contact_modes")
    }
    assert {"planar_pushing.mechanics.scene", "planar_pushing.study.files.replacing"} <= set(
        reached
    )


def test_the_builders_depend_on_each_of_them():
    names = {f"planar_pushing.study.datasets.{name}" for name in ("contact_modes", "scenes")}
    assert names <= set(modules("study.builders"))


def test_the_digest_is_of_what_is_reached():
    assert code_of("study.slices") != code_of("study.storage.store")


def test_a_module_depends_on_the_packages_around_it():
    reached = modules("figures.paper.figure_06")
    assert {
        f"planar_pushing.{name}" for name in ("figures", "figures.paper", "terms.extras")
    } <= set(reached)
    assert "planar_pushing" not in reached
