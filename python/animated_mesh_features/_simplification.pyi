# The types of what is public in the Python file of the same name.
from typing import Any, Dict, List, Literal, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from ._animation import Animation, Frames, PathLike, Visitor
from ._detection import Detection

class Level(NamedTuple):
    vertices: np.ndarray
    faces: np.ndarray
    data: np.ndarray
    indices: np.ndarray
    indptr: np.ndarray
    vertex_of: np.ndarray
    errors: Optional[np.ndarray]
    @property
    def shape(self) -> Tuple[int, int]: ...
    def positions(self, frames: Frames) -> np.ndarray: ...

class Simplification:
    def __init__(self, data: Any, animation: Animation) -> None: ...
    @property
    def animation(self) -> Animation: ...
    @property
    def levels(self) -> List[Level]: ...
    @property
    def poses(self) -> List[int]: ...
    @property
    def report(self) -> Dict[str, Any]: ...

def simplify(frames: Frames, faces: Optional[ArrayLike] = ..., *, vertices: Union[None, int, Sequence[int]] = ...,
             ratio: Optional[float] = ..., lods: Optional[Sequence[float]] = ..., error: Optional[float] = ...,
             poses: Optional[int] = ..., features: Union[None, np.ndarray, Detection] = ...,
             guidance: Optional[float] = ..., normals: Optional[float] = ..., support: Optional[int] = ...,
             refinements: Optional[int] = ..., measure: bool = ...,
             frame_duration: Optional[float] = ..., fps: Optional[float] = ...,
             rest: Union[None, str, int, PathLike, ArrayLike] = ..., rescale_rest: bool = ..., triangulate: bool = ...,
             weld: Literal["auto", "always", "never"] = ..., repair: bool = ..., skip_bad_frames: bool = ...,
             denoise: Optional[Literal["auto", "always", "never"]] = ...,
             memory: Union[None, int, str] = ..., scratch: Optional[PathLike] = ..., threads: Optional[int] = ...,
             visitor: Visitor = ...) -> Simplification: ...
