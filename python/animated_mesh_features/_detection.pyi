# The types of what is public in the Python file of the same name.
import os
from typing import Any, Callable, Dict, List, Literal, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from ._animation import (Animation, Balls, FieldName, Frames, Length, PathLike, Shape, Strain, Visitor)

feature_dtype: np.dtype

class Detection:
    def __init__(self, data: Any, animation: Shape) -> None: ...
    def __len__(self) -> int: ...
    @property
    def features(self) -> np.ndarray: ...
    @property
    def animation(self) -> Shape: ...
    @property
    def deformation(self) -> np.ndarray: ...
    @property
    def strain(self) -> np.ndarray: ...
    @property
    def curvature(self) -> np.ndarray: ...
    @property
    def sigma_levels(self) -> np.ndarray: ...
    @property
    def tau_levels(self) -> np.ndarray: ...
    @property
    def ball_radius(self) -> float: ...
    @property
    def number_of_minima(self) -> int: ...
    @property
    def parameters(self) -> Dict[str, Any]: ...
    @property
    def reason(self) -> str: ...
    def write(self, output: Union[None, PathLike, Sequence[PathLike]] = ..., *,
              write_field: Union[None, str, Sequence[str]] = ..., html: Optional[PathLike] = ...,
              html_every: Optional[int] = ..., vtk: Optional[PathLike] = ..., glb: Optional[PathLike] = ...,
              plot: Optional[PathLike] = ..., png: Optional[PathLike] = ...,
              frame: Union[None, int, Sequence[int]] = ..., png_size: Optional[str] = ...,
              png_background: Optional[str] = ..., view: Optional[str] = ..., up: Optional[str] = ...,
              views: Optional[PathLike] = ..., view_map: Optional[PathLike] = ...,
              vertex_map: Optional[PathLike] = ..., no_sync: bool = ...) -> None: ...

def detect(frames: Frames, faces: Optional[ArrayLike] = ..., *, frame_duration: Optional[float] = ...,
           fps: Optional[float] = ..., rest: Union[None, str, int, PathLike, ArrayLike] = ...,
           rescale_rest: bool = ..., triangulate: bool = ..., weld: Literal["auto", "always", "never"] = ...,
           repair: bool = ..., skip_bad_frames: bool = ...,
           denoise: Optional[Literal["auto", "always", "never"]] = ...,
           preset: Literal["calibrated", "published"] = ..., strain: Optional[Strain] = ...,
           curvature: Optional[Literal["density", "dihedral"]] = ...,
           balls: Optional[Balls] = ..., ball_radius: Optional[Length] = ..., alpha: Optional[float] = ...,
           baseline: Optional[Literal["least", "none"]] = ...,
           spatial_filter: Optional[Literal["heat", "one-ring"]] = ...,
           dimension: Optional[Literal["surface", "plane"]] = ...,
           temporal_filter: Optional[Literal["gaussian", "box"]] = ..., cyclic: bool = ...,
           box_width: Optional[int] = ..., space_counts: Optional[int] = ..., time_counts: Optional[int] = ...,
           sigma_range: Union[None, str, Tuple[Optional[Length], Optional[Length]]] = ...,
           tau_range: Union[None, str, Tuple[Optional[float], Optional[float]]] = ...,
           threshold: Optional[float] = ..., relative_threshold: Optional[float] = ...,
           min_fit: Optional[float] = ..., top: Optional[int] = ..., no_suppression: bool = ...,
           keep_fields: Sequence[FieldName] = ..., memory: Union[None, int, str] = ...,
           scratch: Optional[PathLike] = ..., threads: Optional[int] = ..., visitor: Visitor = ...) -> Detection: ...

def detect_in_field(field: ArrayLike, shape: Union[ArrayLike, Shape], faces: Optional[ArrayLike] = ..., *,
                    frame_duration: Optional[float] = ..., fps: Optional[float] = ..., noise: float = ...,
                    preset: Literal["calibrated", "published"] = ...,
                    baseline: Optional[Literal["least", "none"]] = ...,
                    spatial_filter: Optional[Literal["heat", "one-ring"]] = ...,
                    dimension: Optional[Literal["surface", "plane"]] = ...,
                    temporal_filter: Optional[Literal["gaussian", "box"]] = ..., cyclic: bool = ...,
                    box_width: Optional[int] = ..., space_counts: Optional[int] = ..., time_counts: Optional[int] = ...,
                    sigma_range: Union[None, str, Tuple[Optional[Length], Optional[Length]]] = ...,
                    tau_range: Union[None, str, Tuple[Optional[float], Optional[float]]] = ...,
                    threshold: Optional[float] = ..., relative_threshold: Optional[float] = ...,
                    min_fit: Optional[float] = ..., top: Optional[int] = ..., no_suppression: bool = ...,
                    threads: Optional[int] = ..., visitor: Visitor = ...) -> Detection: ...

def strain(frames: Frames, faces: Optional[ArrayLike] = ..., *, frame_duration: Optional[float] = ...,
           fps: Optional[float] = ..., rest: Union[None, str, int, PathLike, ArrayLike] = ...,
           rescale_rest: bool = ..., triangulate: bool = ..., weld: Literal["auto", "always", "never"] = ...,
           repair: bool = ..., skip_bad_frames: bool = ...,
           denoise: Optional[Literal["auto", "always", "never"]] = ...,
           preset: Literal["calibrated", "published"] = ..., strain: Optional[Strain] = ..., memory: Union[None, int,
           str] = ..., scratch: Optional[PathLike] = ...,
           threads: Optional[int] = ..., visitor: Visitor = ...) -> np.ndarray: ...

def curvature(frames: Frames, faces: Optional[ArrayLike] = ..., *, frame_duration: Optional[float] = ...,
              fps: Optional[float] = ..., rest: Union[None, str, int, PathLike, ArrayLike] = ...,
              rescale_rest: bool = ..., triangulate: bool = ..., weld: Literal["auto", "always", "never"] = ...,
              repair: bool = ..., skip_bad_frames: bool = ...,
              denoise: Optional[Literal["auto", "always", "never"]] = ...,
              preset: Literal["calibrated", "published"] = ..., curvature: Optional[Literal["density",
              "dihedral"]] = ..., balls: Optional[Balls] = ...,
              ball_radius: Optional[Length] = ..., memory: Union[None, int, str] = ...,
              scratch: Optional[PathLike] = ..., threads: Optional[int] = ..., visitor: Visitor = ...
              ) -> np.ndarray: ...

def deformation(frames: Frames, faces: Optional[ArrayLike] = ..., *, frame_duration: Optional[float] = ...,
                fps: Optional[float] = ..., rest: Union[None, str, int, PathLike, ArrayLike] = ...,
                rescale_rest: bool = ..., triangulate: bool = ..., weld: Literal["auto", "always", "never"] = ...,
                repair: bool = ..., skip_bad_frames: bool = ...,
                denoise: Optional[Literal["auto", "always", "never"]] = ...,
                preset: Literal["calibrated", "published"] = ..., strain: Optional[Strain] = ...,
                curvature: Optional[Literal["density", "dihedral"]] = ...,
                balls: Optional[Balls] = ..., ball_radius: Optional[Length] = ..., alpha: Optional[float] = ...,
                baseline: Optional[Literal["least", "none"]] = ..., memory: Union[None, int, str] = ...,
                scratch: Optional[PathLike] = ..., threads: Optional[int] = ..., visitor: Visitor = ...
                ) -> np.ndarray: ...

def geodesic_balls(shape: Union[ArrayLike, Shape], faces: Optional[ArrayLike] = ..., *,
                   ball_radius: Optional[Length] = ..., balls: Optional[Balls] = ..., threads: Optional[int] = ...,
                   visitor: Visitor = ...) -> Tuple[np.ndarray, np.ndarray]: ...
