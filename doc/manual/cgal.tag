<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- The few pages of CGAL's own manual to which this one leads. -->
<tagfile doxygen_version="1.9.4">
  <compound kind="page">
    <name>packages</name>
    <title>Package Overview</title>
    <filename>Manual/packages</filename>
    <docanchor file="Manual/packages.html" title="CGAL and the Boost Graph Library">PkgBGL</docanchor>
    <docanchor file="Manual/packages.html" title="The Heat Method">PkgHeatMethod</docanchor>
    <docanchor file="Manual/packages.html" title="Surface Mesh">PkgSurfaceMesh</docanchor>
    <docanchor file="Manual/packages.html" title="Bounding Volumes">PkgBoundingVolumes</docanchor>
    <docanchor file="Manual/packages.html" title="Triangulated Surface Mesh Simplification">PkgSurfaceMeshSimplification</docanchor>
  </compound>
  <compound kind="page">
    <name>license</name>
    <title>License</title>
    <filename>Manual/license</filename>
    <docanchor file="Manual/license.html" title="GPL">licensesGPL</docanchor>
  </compound>
  <compound kind="class">
    <name>FaceGraph</name>
    <filename>BGL/classFaceGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceListGraph</name>
    <filename>BGL/classFaceListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>VertexListGraph</name>
    <filename>BGL/classVertexListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>EdgeListGraph</name>
    <filename>BGL/classEdgeListGraph.html</filename>
  </compound>
</tagfile>
