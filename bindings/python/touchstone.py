# SPDX-License-Identifier: Apache-2.0
"""The former name of touchstone_contact. Another package of the Python package index has it, so version 0.4 drops it."""

import warnings

from touchstone_contact import *  # noqa: F401,F403
from touchstone_contact import _remade  # noqa: F401  older pickles name it here

warnings.warn("import touchstone_contact instead of touchstone, which version 0.4 drops", DeprecationWarning, stacklevel=2)
