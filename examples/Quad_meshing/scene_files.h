// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXAMPLES_SCENE_FILES_H
#define CGAL_QUAD_MESHING_EXAMPLES_SCENE_FILES_H

// The options --html, --picture and --vtk of the command-line programs: a page that shows in three dimensions what the
// program did, a picture of its result, and the result with its measures for ParaView.

#include "command_line.h"

#include <CGAL/Quad_meshing/IO/write_html_page.h>
#include <CGAL/Quad_meshing/IO/write_png_picture.h>
#include <CGAL/Quad_meshing/IO/write_vtk.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace command_line {

// Adds the options.
inline void add_scene_options(po::options_description& options)
{
  options.add_options()("html", po::value<std::string>(),
                        "HTML file that shows the result in three dimensions, without network")(
    "picture", po::value<std::string>(), "PNG file with a picture of the result, 640 x 480")(
    "vtk", po::value<std::string>(), "VTK file with the faces of the result and their measures as data of the cells")(
    "color-by", po::value<std::string>(),
    "what colors the faces of page and picture: a name in the page, or its beginning, as patch or scaled")(
    "show", po::value<std::string>(),
    "the layers that page and picture show at first, separated by commas: names in the page, or their beginnings, as "
    "triangles,cross");
}

inline bool shows_scene(const Arguments& args) { return args.has("html") || args.has("picture") || args.has("vtk"); }

// Throws, before a long computation, if what is asked for cannot be written.
inline void check_scene_files(const Arguments& args)
{
  if(args.has("picture"))
    check_output(args.value<std::string>("picture"), { "png" });
  if(args.has("vtk"))
    check_output(args.value<std::string>("vtk"), { "vtk" });
  if(!args.has("html"))
    return;
  if(!CGAL::Quad_meshing::has_html_viewer())
    throw Unusable_input("--html: this program was built without three.js (Debian's libjs-three)");
  check_output(args.value<std::string>("html"), { "html", "htm" });
}

// Writes a picture of the result, or of all that is visible if there is no result or layers were chosen.
inline CGAL::Quad_meshing::Scene_writing_result write_picture(std::ostream& os, const CGAL::Quad_meshing::Scene& scene,
                                                              bool is_chosen)
{
  CGAL::Quad_meshing::Png_picture_options options;
  if(is_chosen || std::none_of(scene.layers.begin(), scene.layers.end(),
                               [&](const CGAL::Quad_meshing::Scene_layer& l) { return l.side == options.side; }))
    options.side = CGAL::Quad_meshing::Scene_side::BOTH;
  return CGAL::Quad_meshing::write_png_picture(os, scene, options);
}

// Shows the layers whose names begin with one of those in a list separated by commas, and no others. Layers of
// different groups may have one name: GROUP/NAME is one of them. A run that failed may lack some, which is said.
inline void show_layers(const std::string& list, CGAL::Quad_meshing::Scene& scene)
{
  for(CGAL::Quad_meshing::Scene_layer& layer : scene.layers)
    layer.is_visible = false;
  std::istringstream names(list);
  for(std::string name; std::getline(names, name, ',');)
  {
    const auto is_meant = [&](const CGAL::Quad_meshing::Scene_layer& layer)
    {
      return layer.name.compare(0, name.size(), name) == 0 ||
             (layer.group + "/" + layer.name).compare(0, name.size(), name) == 0;
    };
    bool is_found = false;
    for(CGAL::Quad_meshing::Scene_layer& layer : scene.layers)
      if(is_meant(layer))
        is_found = layer.is_visible = true;
    if(is_found)
      continue;
    std::cerr << "--show: no layer is called '" << name << "'; there are";
    for(const CGAL::Quad_meshing::Scene_layer& layer : scene.layers)
      std::cerr << (&layer == &scene.layers.front() ? " '" : ", '") << layer.group << "/" << layer.name << "'";
    std::cerr << "\n";
  }
}

// Writes the last faces of a scene, which are those of the result.
inline CGAL::Quad_meshing::Scene_writing_result write_faces(std::ostream& os, const CGAL::Quad_meshing::Scene& scene)
{
  const auto faces = std::find_if(scene.layers.rbegin(), scene.layers.rend(),
                                  [](const CGAL::Quad_meshing::Scene_layer& l)
                                  { return l.kind == CGAL::Quad_meshing::Scene_layer_kind::FACES; });
  return CGAL::Quad_meshing::write_vtk(os, faces == scene.layers.rend() ? CGAL::Quad_meshing::Scene_layer() : *faces);
}

// Colors all faces that have numbers of that name, or one that begins so. A run that failed may have none: the error is
// said, and the files are written.
inline void color_faces(const std::string& name, CGAL::Quad_meshing::Scene& scene)
{
  bool is_found = false;
  std::string names;
  for(CGAL::Quad_meshing::Scene_layer& layer : scene.layers)
    for(std::size_t i = 0; layer.kind == CGAL::Quad_meshing::Scene_layer_kind::FACES && i < layer.numbers.size(); ++i)
    {
      names += (names.empty() ? "'" : ", '") + layer.numbers[i].name + "'";
      if(layer.numbers[i].name.compare(0, name.size(), name) != 0)
        continue;
      layer.colored_by = static_cast<int>(i);
      is_found = true;
      break;
    }
  if(!is_found)
    std::cerr << "--color-by: nothing is called '" << name << "'; there are " << (names.empty() ? "no numbers" : names)
              << "\n";
}

// Writes the files. `scene` has layers and a message; figures, options and title are put in.
inline void write_scene_files(const Arguments& args, const CGAL::Quad_meshing::Flat_json& figures,
                              CGAL::Quad_meshing::Scene& scene)
{
  const std::string& input = args.positional(0);
  scene.title = input.substr(input.find_last_of("/\\") + 1);
  scene.figures.clear();
  for(const auto& member : figures.members())
    if(member.first != "message")
      scene.figures.push_back(member);
  scene.options = args.values();
  if(args.has("color-by"))
    color_faces(args.value<std::string>("color-by"), scene);
  if(args.has("show"))
    show_layers(args.value<std::string>("show"), scene);
  for(const std::string option : { "html", "picture", "vtk" })
    if(args.has(option))
    {
      const std::string filename = args.value<std::string>(option);
      std::ofstream out = open_output(filename);
      const CGAL::Quad_meshing::Scene_writing_result result =
        option == "html"      ? CGAL::Quad_meshing::write_html_page(out, scene)
        : option == "picture" ? write_picture(out, scene, args.has("show"))
                              : write_faces(out, scene);
      if(!result.is_valid())
        throw Unusable_input(filename + ": " + result.message);
    }
}

} // namespace command_line

#endif // CGAL_QUAD_MESHING_EXAMPLES_SCENE_FILES_H
