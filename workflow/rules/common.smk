# The study, validated before any job starts, and what all rules use.
from snakemake.exceptions import WorkflowError

from planar_pushing.mechanics.errors import PlanarPushingError
from planar_pushing.study.files import load_study
from planar_pushing.study.jobs import modules

STUDY_FILE = config.get("study", "workflow/config/paper.yaml")
try:
    STUDY = load_study(STUDY_FILE)
except PlanarPushingError as error:
    raise WorkflowError(str(error)) from None
