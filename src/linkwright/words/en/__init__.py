"""English words, by key. Chinese and others follow as packages beside this one."""

from linkwright.words.en.accuracy import ACCURACY
from linkwright.words.en.batch import BATCH
from linkwright.words.en.cams import CAMS
from linkwright.words.en.export import EXPORT
from linkwright.words.en.findings import FINDINGS
from linkwright.words.en.limits import LIMITS
from linkwright.words.en.process_simulate import PROCESS_SIMULATE
from linkwright.words.en.reactions import REACTIONS
from linkwright.words.en.report import REPORT
from linkwright.words.en.sheet import SHEET
from linkwright.words.en.sweep import SWEEP
from linkwright.words.en.texts import TEXTS
from linkwright.words.en.workspace import WORKSPACE
from linkwright.words.en.workspace_maps import WORKSPACE_MAPS
from linkwright.words.en.workspace_paths import WORKSPACE_PATHS
from linkwright.words.en.workspace_trajectories import WORKSPACE_TRAJECTORIES

PARTS = (
    ACCURACY,
    BATCH,
    CAMS,
    EXPORT,
    FINDINGS,
    LIMITS,
    PROCESS_SIMULATE,
    REACTIONS,
    REPORT,
    SHEET,
    SWEEP,
    TEXTS,
    WORKSPACE,
    WORKSPACE_MAPS,
    WORKSPACE_PATHS,
    WORKSPACE_TRAJECTORIES,
)
WORDS: dict[str, str] = {key: text for part in PARTS for key, text in part.items()}
