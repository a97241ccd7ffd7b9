# The types of what is public in the Python file of the same name.
from typing import NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from ._animation import Animation, Visitor
from ._detection import Detection

class Views(NamedTuple):
    direction: np.ndarray
    azimuth: np.ndarray
    elevation: np.ndarray
    score: np.ndarray
    covered: np.ndarray
    up: np.ndarray
    frames: np.ndarray
    directions: np.ndarray
    scores: np.ndarray

def select_views(animation: Union[Animation, Detection], features: Optional[np.ndarray] = ..., *,
                 up: Union[None, str, ArrayLike] = ..., subdivisions: int = ..., refinements: int = ...,
                 most_frames: int = ..., most_views: int = ..., lowest_elevation: float = ...,
                 highest_elevation: float = ..., cyclic: bool = ..., threads: Optional[int] = ...,
                 visitor: Visitor = ...) -> Views: ...
