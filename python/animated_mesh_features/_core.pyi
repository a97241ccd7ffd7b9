# The extension module, which is no interface: see the Python files beside it.
from typing import Any, Callable, Dict, List, Optional, Tuple, Union

import numpy as np

__version__: str
has_threads: bool
feature_dtype: np.dtype
READING: int
METHOD: int
OUTPUT: int
COMPARISON: int
SIMPLIFICATION: int

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

class SignatureData:
    number_of_vertices: int
    number_of_frames: int
    frame_duration: float
    bounding_box_diagonal: float
    features: np.ndarray
    descriptors: np.ndarray
    activity: np.ndarray
    rate: float
    period: float
    cycle_strength: float
    pose_variation: Optional[float]

class AlignmentData:
    times_a: np.ndarray
    times_b: np.ndarray
    cost: float
    confidence: float
    phase: Optional[float]
    pairs: np.ndarray
    only_a: np.ndarray
    only_b: np.ndarray
    score: float
    def to_a(self, times: Any) -> Any: ...
    def to_b(self, times: Any) -> Any: ...

class SimplificationData:
    number_of_levels: int
    poses: List[int]
    report: str
    table: str
    def vertices(self, level: int) -> np.ndarray: ...
    def faces(self, level: int) -> np.ndarray: ...
    def binding(self, level: int) -> Tuple[np.ndarray, np.ndarray, np.ndarray]: ...
    def vertex_of(self, level: int) -> np.ndarray: ...
    def errors(self, level: int) -> Optional[np.ndarray]: ...

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
def read_painting(path: str) -> Dict[str, Any]: ...
def map_scores(map: np.ndarray, marks: np.ndarray, areas: np.ndarray) -> Tuple[float, float, float]: ...
def bootstrap_interval(sample: np.ndarray, statistic: Optional[Callable[[np.ndarray], float]], resamples: int,
                       confidence: float, seed: int) -> Tuple[float, float]: ...
def random_places(features: int, vertices: int, duration: float, draws: int,
                  seed: int) -> Tuple[np.ndarray, np.ndarray]: ...
def prominent_maxima(series: np.ndarray, least: float) -> List[Tuple[int, float, float]]: ...
def rig_matches(points: np.ndarray, size: float, regions: List[List[int]],
                events: List[Tuple[int, float, float, float]], frames: int, frame_duration: float, features: np.ndarray,
                options: RigOptions) -> Tuple[np.ndarray, np.ndarray, List[int], List[Tuple[int, float]]]: ...
def descriptors(detection: DetectionData, features: np.ndarray, arguments: List[str],
                visitor: _Visitor) -> np.ndarray: ...
def signature(detection: DetectionData, features: np.ndarray, arguments: List[str],
              visitor: _Visitor) -> SignatureData: ...
def signature_of_features(features: np.ndarray, vertices: int, frames: int, frame_duration: float, diagonal: float,
                          arguments: List[str]) -> SignatureData: ...
def match_features(a: SignatureData, b: SignatureData, arguments: List[str], visitor: _Visitor) -> np.ndarray: ...
def align(a: SignatureData, b: SignatureData, arguments: List[str], visitor: _Visitor) -> AlignmentData: ...
def distances(signatures: List[SignatureData], arguments: List[str], visitor: _Visitor) -> np.ndarray: ...
def event_differences(a: SignatureData, b: SignatureData, alignment: AlignmentData, place: float, profile: float,
                      frames: float, factor: float) -> np.ndarray: ...
def classical_scaling(distances: np.ndarray) -> np.ndarray: ...
def simplify(animation: AnimationData, features: np.ndarray, arguments: List[str], is_measured: bool,
             visitor: _Visitor) -> SimplificationData: ...
def write_animation(mesh: str, cache: str, is_mdd: bool, rest: np.ndarray, faces: np.ndarray, frames: int,
                    frame_duration: float, frame_of: Callable[[int], np.ndarray]) -> None: ...
def select_views(animation: AnimationData, features: np.ndarray, up: Optional[List[float]], subdivisions: int,
                 refinements: int, most_frames: int, most_views: int, lowest_elevation: float,
                 highest_elevation: float, arguments: List[str], visitor: _Visitor) -> Dict[str, np.ndarray]: ...
