# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The exceptions of the package, told apart by what the caller can do about them; each is one of Python's own, too."""

import sys
import warnings


class Error(RuntimeError):
    """The base of all exceptions that the package throws for a reason that the caller can meet in practice."""


class InputError(Error, ValueError):
    """The data are unusable: a shape that is none, a face that is no triangle, a coordinate that is not finite, a file
    that is missing or malformed. The message names the frame, the vertex or the face. Repair the data."""


class OptionError(Error, ValueError):
    """An option has a value that makes no sense, or none for this animation. The message names it as the command line
    does: ``--sigma-range`` is the keyword ``sigma_range``. Change the option."""


class OutputError(Error, OSError):
    """A result could not be written. What stood under that name before is still there."""


class NumericalError(Error, ArithmeticError):
    """A numerical method failed, for instance the factorisation of a Laplacian."""


class Cancelled(Error):
    """The visitor asked to stop. There is no result."""


class Notice(UserWarning):
    """What must be known of an animation to judge the result: vertices that were welded, frames that were left out, an
    unusual rest shape. The command line writes it as ``note: ...``."""


def tell(*notices):
    """warns of the line that called the package."""
    frame, level = sys._getframe(), 1
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        frame, level = frame.f_back, level + 1
    for notice in notices:
        warnings.warn(notice, Notice, stacklevel=level)
