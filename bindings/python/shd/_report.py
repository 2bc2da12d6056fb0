# SPDX-License-Identifier: MIT
"""Logs and progress: loggers and functions as the log of a context, and a bar for long frames."""
import sys
import time

from . import _api

DELAY = 0.5  # seconds of a frame before its bar appears
WIDTH = 30   # characters of the bar


def log_writer(value, name):
    """The function of a log: write(level, message) for a logging.Logger or a function of that kind."""
    if hasattr(value, "isEnabledFor") and hasattr(value, "log"):
        return lambda level, message: value.log(10 * (level + 1), "%s", message)  # DEBUG 10, INFO 20, ...
    if not callable(value):
        raise TypeError(f"{name}: a logging.Logger, a function or a dict of its fields, not {type(value).__name__}")
    levels = _api.enum_type("shd_log_level")
    return lambda level, message: value(levels(level), message)


def reporter(value, name):
    """The function of progress: report(fraction). True is a bar."""
    if value is True:
        return Bar()
    if not callable(value):
        raise TypeError(f"{name}: True, a function or a dict of its fields, not {type(value).__name__}")
    return value


class Bar:
    """A bar for frames that take longer than DELAY, by tqdm if it is there, else a line on stderr."""

    def __init__(self, label="render"):
        self._label, self._start, self._shown, self._fraction = label, time.monotonic(), None, 0.0

    def __call__(self, fraction):
        if self._shown is None and time.monotonic() - self._start >= DELAY:
            self._shown = tqdm_bar(self._label) or Line(self._label)
        if self._shown is not None:
            self._shown.update(fraction - self._fraction)
            self._fraction = fraction

    def close(self):
        """Ends the line of the bar."""
        if self._shown is not None:
            self._shown.close()
            self._shown = None


def tqdm_bar(label):
    """A bar of tqdm, or None without the package."""
    try:
        from tqdm import tqdm
    except ImportError:
        return None
    return tqdm(total=1.0, desc=label, bar_format="{l_bar}{bar}| {elapsed}<{remaining}")


class Line:
    """A line on stderr, written again when its text changes."""

    def __init__(self, label):
        self._label, self._done, self._text = label, 0.0, None

    def update(self, part):
        self._done += part
        full = int(WIDTH * self._done + 1e-6)
        text = f"{self._label} [{'#' * full}{'.' * (WIDTH - full)}] {100 * self._done:3.0f} %"
        if text != self._text:
            self._text = text
            sys.stderr.write("\r" + text)
            sys.stderr.flush()

    def close(self):
        sys.stderr.write("\n")
