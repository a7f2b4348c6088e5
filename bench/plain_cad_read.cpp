// SPDX-License-Identifier: Apache-2.0
// The peer of the importer's figures: plain OpenCASCADE or assimp reading (and meshing) files, nothing more.
// usage: plain_cad_read FILE...  ->  seconds, seconds of processor, triangles, largest resident memory
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <sys/resource.h>
#include <unistd.h>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <assimp/Importer.hpp>
#include <chrono>
#include <cstdio>
#include <string>

namespace {

long readStep(const char* file) {
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
  STEPCAFControl_Reader reader;
  reader.SetNameMode(true);
  reader.SetColorMode(true);
  if (reader.ReadFile(file) != IFSelect_RetDone || !reader.Transfer(document)) return -1;
  TDF_LabelSequence labels;
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(labels);
  long triangles = 0;
  constexpr double kChord_mm = 0.1, kAngle = 0.3;  // As our own defaults.
  for (const TDF_Label& label : labels) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    const BRepMesh_IncrementalMesh mesher(shape, kChord_mm, false, kAngle, false);
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
      TopLoc_Location location;
      const auto triangulation = BRep_Tool::Triangulation(TopoDS::Face(faces.Current()), location);
      if (!triangulation.IsNull()) triangles += triangulation->NbTriangles();
    }
  }
  return triangles;
}

long readOther(const char* file) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file, aiProcess_Triangulate);
  if (!scene) return -1;
  long triangles = 0;
  for (unsigned k = 0; k < scene->mNumMeshes; ++k) triangles += scene->mMeshes[k]->mNumFaces;
  return triangles;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const auto begin = std::chrono::steady_clock::now();
  long triangles = 0;
  for (int k = 1; k < argc; ++k) {
    const std::string file = argv[k];
    const bool step = file.ends_with(".step") || file.ends_with(".stp");
    const long count = step ? readStep(argv[k]) : readOther(argv[k]);
    if (count < 0) ::_exit(1);
    triangles += count;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const auto inSeconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  std::printf("%.3f s, %.3f s of processor, %ld triangles, %ld MB\n", seconds,
              inSeconds(used.ru_utime) + inSeconds(used.ru_stime), triangles, used.ru_maxrss / 1024);
  std::fflush(stdout);
  ::_exit(0);
}
