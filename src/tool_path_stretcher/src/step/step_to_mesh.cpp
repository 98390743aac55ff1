// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <Bnd_Box.hxx>
#include <CLI/CLI.hpp>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StlAPI_Writer.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdio>
#include <string>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/tools/tool_main.h"

using scan_cell_common::FileError;

namespace {

struct Options {
  std::string input;
  std::string output;
  double deviation = 0.05;  // [mm]
};

/// [mm], whatever the unit of the file.
TopoDS_Shape read_step(const std::string& path) {
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw FileError(path, "not a readable STEP file", "check it, or export the part again");
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();
  if (shape.IsNull())
    throw FileError(path, "holds no surface", "export solids or surfaces, not only curves");
  return shape;
}

void run(const Options& options) {
  constexpr double kTurn = 0.35;  // [rad] 20 degrees between neighbouring facets; chosen
  constexpr bool kRelative = false, kParallel = true;
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  const TopoDS_Shape shape = read_step(options.input);
  BRepMesh_IncrementalMesh(shape, options.deviation, kRelative, kTurn, kParallel);
  StlAPI_Writer writer;
  writer.ASCIIMode() = false;
  if (!writer.Write(shape, options.output.c_str()))
    throw FileError(options.output, "cannot be written, or there is no face to write",
                    "check the folder, and that the STEP file holds surfaces");
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  double x_min, y_min, z_min, x_max, y_max, z_max;
  box.Get(x_min, y_min, z_min, x_max, y_max, z_max);
  std::printf("%s: %.1f x %.1f x %.1f mm; in millimetres (stretch --reference-units mm)\n",
              options.output.c_str(), x_max - x_min, y_max - y_min, z_max - z_min);
}

void add_options(CLI::App& app, Options& options, scan_cell_common::Outputs& outputs) {
  app.add_option("--input", options.input, "part (.step, .stp)")
      ->required()
      ->check(CLI::ExistingFile);
  outputs.add(app, "--output", options.output, "its mesh in millimetres (.stl)")
      ->required()
      ->check([](const std::string& path) {
        const bool is_stl = path.size() > 4 && path.substr(path.size() - 4) == ".stl";
        return is_stl ? "" : path + ": give a name that ends in .stl";
      });
  app.add_option("--deviation", options.deviation,
                 "largest deviation of the mesh from the part [mm]")
      ->capture_default_str()
      ->check(CLI::Range(1e-4, 10.0));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Makes a mesh of a STEP file, for stretch --reference and plan_passes.");
  scan_cell_common::Outputs outputs;
  Options options;
  add_options(app, options, outputs);
  return scan_cell_common::tool_main(
      "step_to_mesh", app, argc, argv,
      [&] {
        try {
          run(options);
        } catch (const Standard_Failure& failure) {
          throw FileError(options.input, failure.GetMessageString(), "export the part again");
        }
        return 0;
      },
      scan_cell_common::kUnusable, outputs);
}
