# The extension module, which is no interface: see the Python files beside it.
from typing import Any, Callable, Dict, List, Optional, Tuple, Union

import numpy as np

__version__: str
has_threads: bool
feature_dtype: np.dtype
READING: int
METHOD: int
OUTPUT: int

_Visitor = Optional[Callable[[str, float], Any]]

class ShapeData:
    vertices: np.ndarray
    faces: np.ndarray
    areas: np.ndarray
    diameter: float
    bounding_box_diagonal: float
    mean_edge_length: float

class MeshData(ShapeData):
    def __init__(self, vertices: np.ndarray, faces: np.ndarray) -> None: ...

class AnimationData(ShapeData):
    positions: np.ndarray
    vertex_of_input: np.ndarray
    number_of_frames: int
    number_of_vertices: int
    fps: float
    frame_duration: float
    notices: List[str]
    remarks: List[str]
    clips: List[str]
    clip: str
    files: List[str]
    rest: str
    rest_name: str
    rest_factor: float
    def trajectories(self, axis: int) -> np.ndarray: ...

class DetectionData:
    features: np.ndarray
    description: Dict[str, Dict[str, Any]]
    reason: str
    number_of_minima: int
    sigma_levels: np.ndarray
    tau_levels: np.ndarray
    ball_radius: float
    def field(self, kind: str) -> Optional[np.ndarray]: ...
    def write(self, arguments: List[str]) -> None: ...

class RigOptions:
    least_prominence: float
    least_angle: float
    least_recalled_angle: float
    largest_distance: float
    frames: float
    share_of_tau: float

def help_of(taken: int) -> str: ...
def animation_of_arrays(frames: List[np.ndarray], faces: np.ndarray, rest: np.ndarray, arguments: List[str],
                        visitor: _Visitor) -> AnimationData: ...
def animation_of_files(inputs: List[str], arguments: List[str], visitor: _Visitor) -> AnimationData: ...
def detect(animation: AnimationData, arguments: List[str], kept: List[str], visitor: _Visitor) -> DetectionData: ...
def detect_in_field(shape: ShapeData, field: np.ndarray, frame_duration: float, noise: float, arguments: List[str],
                    visitor: _Visitor) -> DetectionData: ...
def measure(animation: AnimationData, kind: str, arguments: List[str], visitor: _Visitor) -> np.ndarray: ...
def geodesic_balls(shape: ShapeData, arguments: List[str], visitor: _Visitor) -> Tuple[np.ndarray, np.ndarray]: ...
def read_features(path: str) -> Dict[str, Any]: ...
def repeated_features(features: np.ndarray, others: np.ndarray, top: int, among: int, place: float, time: float,
                      factor: float, at_rest: bool) -> Tuple[np.ndarray, np.ndarray]: ...
def paired_features(a: np.ndarray, b: np.ndarray, place: float, time: float, factor: float,
                    at_rest: bool) -> Tuple[np.ndarray, np.ndarray]: ...
def matching_errors(shape: ShapeData, features: np.ndarray, others: np.ndarray, time: float) -> np.ndarray: ...
def feature_regions(shape: ShapeData, features: np.ndarray, frames: int, frame_duration: float,
                    is_gaussian: bool) -> np.ndarray: ...
def map_scores(map: np.ndarray, marks: np.ndarray, areas: np.ndarray) -> Tuple[float, float, float]: ...
def bootstrap_interval(sample: np.ndarray, statistic: Optional[Callable[[np.ndarray], float]], resamples: int,
                       confidence: float, seed: int) -> Tuple[float, float]: ...
def random_places(features: int, vertices: int, duration: float, draws: int,
                  seed: int) -> Tuple[np.ndarray, np.ndarray]: ...
def prominent_maxima(series: np.ndarray, least: float) -> List[Tuple[int, float, float]]: ...
def rig_matches(points: np.ndarray, size: float, regions: List[List[int]],
                events: List[Tuple[int, float, float, float]], frames: int, frame_duration: float, features: np.ndarray,
                options: RigOptions) -> Tuple[np.ndarray, np.ndarray, List[int], List[Tuple[int, float]]]: ...
