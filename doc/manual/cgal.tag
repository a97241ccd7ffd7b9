<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<tagfile doxygen_version="1.9.4">
  <compound kind="page">
    <name>packages</name>
    <title>Package Overview</title>
    <filename>Manual/packages</filename>
    <docanchor file="Manual/packages.html" title="CGAL and the Boost Graph Library">PkgBGL</docanchor>
    <docanchor file="Manual/packages.html" title="The Heat Method">PkgHeatMethod</docanchor>
    <docanchor file="Manual/packages.html" title="Surface Mesh">PkgSurfaceMesh</docanchor>
    <docanchor file="Manual/packages.html" title="Bounding Volumes">PkgBoundingVolumes</docanchor>
  </compound>
  <compound kind="page">
    <name>license</name>
    <title>License</title>
    <filename>Manual/license</filename>
    <docanchor file="Manual/license.html" title="GPL">licensesGPL</docanchor>
  </compound>
</tagfile>
