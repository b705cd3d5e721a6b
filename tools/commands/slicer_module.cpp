#include "tools/commands/slicer_module.h"

#include <algorithm>

namespace isoloop {
namespace {

constexpr const char* descriptor_head = R"xml(<?xml version="1.0" encoding="utf-8"?>
<executable>
  <category>Quantification</category>
  <title>Handles and Tunnels (isoloop)</title>
  <description><![CDATA[Finds and proves every handle and every tunnel of the solid at or above an iso value: a closed curve round each, with its length, where it is, and how far it extends. Segmentations go in as label map volumes.]]></description>
)xml";

constexpr const char* descriptor_body =
    R"xml(  <documentation-url>docs/where_people_work.md</documentation-url>
  <license>MIT</license>
  <contributor>the isoloop maintainers</contributor>
  <acknowledgements><![CDATA[Dey, Li, Sun and Cohen-Steiner, Computing geometry-aware handle and tunnel loops in 3D models, SIGGRAPH 2008.]]></acknowledgements>
  <parameters>
    <label>Input and output</label>
    <description>What to read, and what to make of it</description>
    <image type="scalar">
      <name>inputVolume</name>
      <label>Input volume</label>
      <description>A scan, a distance map or a label map</description>
      <channel>input</channel>
      <index>0</index>
    </image>
    <geometry type="model" fileExtensions=".vtp">
      <name>curves</name>
      <longflag>--curves</longflag>
      <label>Loops</label>
      <description>Closed curves; cell data: kind (0 handle, 1 tunnel), loop, size, length</description>
      <channel>output</channel>
    </geometry>
    <geometry type="model" fileExtensions=".vtp">
      <name>surface</name>
      <longflag>--surface</longflag>
      <label>Surface</label>
      <description>The iso-surface that the loops run on</description>
      <channel>output</channel>
    </geometry>
    <image type="label" fileExtensions=".nrrd">
      <name>labels</name>
      <longflag>--labels</longflag>
      <label>Labels</label>
      <description>Voxels beside each handle and tunnel have its label</description>
      <channel>output</channel>
    </image>
    <table fileExtensions=".csv">
      <name>csv</name>
      <longflag>--csv</longflag>
      <label>Table</label>
      <description>A row for each loop: length, size, centre</description>
      <channel>output</channel>
    </table>
  </parameters>
  <parameters>
    <label>Solid</label>
    <description>Which voxels are the solid</description>
    <double>
      <name>iso</name>
      <longflag>--iso</longflag>
      <label>Iso value</label>
      <description>The solid is the voxels at or above it; 0.5 for a mask of 0 and 1</description>
      <default>0.5</default>
    </double>
    <string-enumeration>
      <name>inside</name>
      <longflag>--inside</longflag>
      <label>Inside</label>
      <description>Whether the solid is above or below the iso value</description>
      <default>above</default>
      <element>above</element>
      <element>below</element>
    </string-enumeration>
    <string-enumeration>
      <name>side</name>
      <longflag>--side</longflag>
      <label>Which loops</label>
      <description>Those round handles, those round tunnels, or both</description>
      <default>both</default>
      <element>both</element>
      <element>handle</element>
      <element>tunnel</element>
    </string-enumeration>
  </parameters>
  <parameters advanced="true">
    <label>Details</label>
    <description>Sizes to show, and how loops are found</description>
    <double>
      <name>minSize</name>
      <longflag>--min-size</longflag>
      <label>Least size</label>
      <description>Smaller loops are left out, mm</description>
      <default>0</default>
    </double>
    <string-enumeration>
      <name>topology</name>
      <longflag>--topology</longflag>
      <label>Topology</label>
      <description>Of the surface within the cubes between voxels</description>
      <default>trilinear</default>
      <element>trilinear</element>
      <element>simple</element>
    </string-enumeration>
    <string-enumeration>
      <name>tighten</name>
      <longflag>--tighten</longflag>
      <label>Tighten</label>
      <description>Loops as found, exchanged for shorter ones, or drawn straight too</description>
      <default>basis</default>
      <element>none</element>
      <element>basis</element>
      <element>curve</element>
    </string-enumeration>
    <boolean>
      <name>features</name>
      <longflag>--features</longflag>
      <label>Features</label>
      <description>Also measure how far each handle and tunnel extends</description>
      <default>false</default>
    </boolean>
    <boolean hidden="true">
      <name>slicer</name>
      <longflag>--slicer</longflag>
      <label>Called by Slicer</label>
      <description>Progress is told as Slicer reads it</description>
      <default>true</default>
    </boolean>
  </parameters>
</executable>
)xml";

constexpr const char* slicer_flag = "--slicer";

}  // namespace

std::string slicer_descriptor() {
  return std::string(descriptor_head) + "  <version>" ISOLOOP_VERSION "</version>\n" +
         descriptor_body;
}

std::vector<std::string> with_slicer_command(const std::vector<std::string>& arguments) {
  if (arguments.empty() || !arguments[0].starts_with('-') ||
      std::find(arguments.begin(), arguments.end(), slicer_flag) == arguments.end())
    return arguments;
  std::vector<std::string> called{"loops"};
  called.insert(called.end(), arguments.begin(), arguments.end());
  return called;
}

}  // namespace isoloop
