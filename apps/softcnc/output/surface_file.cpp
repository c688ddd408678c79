// SPDX-License-Identifier: MIT
#include "output/surface_file.hpp"

#include "hal/files/npz_file.hpp"
#include "hal/files/suffix.hpp"
#include "hal/files/temporary_file.hpp"
#include "hal/files/zip_file.hpp"
#include "pictures/surface_picture.hpp"

namespace softcnc::app {
namespace {

/// heights_mm, rmax_um, target_um, met, gouges_um, origin_mm, step_mm, region_mm.
class SurfaceArrays final : public SurfaceFile {
 public:
  SurfaceArrays(hal::OutputFile& output, const surface::StockGrid& grid)
      : output_(output), grid_(grid), heights_(grid.rows, grid.columns) {}

  Status add(const surface::SurfaceBand& band) override { return heights_.add(band.heights); }

  Status finish(const surface::RoughnessMap& map) override {
    const std::int64_t regions[] = {map.rows(), map.columns()};
    const std::int64_t axes[] = {kAxes};
    const double region = map.side() * grid_.step;
    const auto archive = hal::TemporaryFile::make();
    if (!archive) return tl::make_unexpected(archive.error());
    hal::ZipWriter zip(archive->descriptor());
    zip.add_descriptor("heights_mm.npy", heights_.descriptor(), hal::Compression::store);
    zip.add_text("rmax_um.npy", hal::npy(std::span<const float>(map.rmax()), regions));
    zip.add_text("target_um.npy", hal::npy(std::span<const float>(map.targets()), regions));
    zip.add_text("met.npy", hal::npy(std::span<const float>(map.met()), regions));
    zip.add_text("gouges_um.npy", hal::npy(std::span<const float>(map.gouges()), regions));
    zip.add_text("origin_mm.npy", hal::npy(std::span(grid_.corner.data(), kAxes), axes));
    zip.add_text("step_mm.npy", hal::npy(std::span(&grid_.step, 1), {}));
    zip.add_text("region_mm.npy", hal::npy(std::span(&region, 1), {}));
    if (Status written = zip.finish(); !written) return written;
    return archive->copy_to(output_);
  }

 private:
  hal::OutputFile& output_;
  surface::StockGrid grid_;
  hal::NpyWriter heights_;
};

class SurfacePng final : public SurfaceFile {
 public:
  SurfacePng(const std::string& title, hal::OutputFile& output, const surface::StockGrid& grid,
             int region)
      : output_(output), picture_(title, grid, region) {}

  Status add(const surface::SurfaceBand& band) override {
    picture_.add(band);
    return {};
  }

  Status finish(const surface::RoughnessMap& map) override {
    const auto png = picture_.draw(map);
    if (!png) return tl::make_unexpected(png.error());
    if (Status written = output_.write(*png); !written) return written;
    return output_.finish();
  }

 private:
  hal::OutputFile& output_;
  SurfacePicture picture_;
};

}  // namespace

Status known_surface_form(const std::string& file) {
  if (hal::has_suffix(file, ".npz") || hal::has_suffix(file, ".png")) return {};
  return tl::make_unexpected(
      Diagnostic{.code = Code::SC6060,
                 .message = "no form of a surface has this suffix; known are .npz, .png",
                 .file = file});
}

Result<std::unique_ptr<SurfaceFile>> open_surface_file(const std::string& name,
                                                       const std::string& title,
                                                       hal::OutputFile& output,
                                                       const surface::StockGrid& grid, int region) {
  if (hal::has_suffix(name, ".png"))
    return std::make_unique<SurfacePng>(title, output, grid, region);
  return std::make_unique<SurfaceArrays>(output, grid);
}

}  // namespace softcnc::app
