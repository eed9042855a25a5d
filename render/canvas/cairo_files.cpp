// Scenes as PDF and PNG.
// SPDX-License-Identifier: MIT
#include <cairo-pdf.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "render/canvas/cairo_canvas.h"
#include "render/canvas/cairo_handles.h"
#include "render/canvas/cairo_pixels.h"
#include "render/canvas/number_text.h"
#include "render/canvas/page_check.h"
#include "render/canvas/png.h"
#include "render/canvas/write.h"

namespace kiri {
namespace {

constexpr double kInch = 25.4;  // mm

cairo_status_t appendBytes(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

Error failure(const char* what, cairo_status_t status) {
  return Error{ErrorCode::Unwritable,
               std::string("the ") + what + " could not be drawn: " +
                   cairo_status_to_string(status) + "; try a smaller picture",
               {}};
}

}  // namespace

Result<std::string> writePdf(const Scene& scene) {
  const Status size = checkPage(scene);
  if (!size) return size.error();
  constexpr double kLargest = 5000;
  if (scene.width > kLargest || scene.height > kLargest) {
    return Error{
        ErrorCode::BadValue, "PDF pages are at most 5 m on a side; choose a smaller scale", {}};
  }
  constexpr double kPoints = 72 / kInch;  // in a mm
  std::string bytes;
  {
    const CairoSurface surface(cairo_pdf_surface_create_for_stream(
        appendBytes, &bytes, scene.width * kPoints, scene.height * kPoints));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, scene.title.c_str());
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR, "KiriSim");
    // Without a date: the same scene gives the same bytes.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
    const CairoContext cr(cairo_create(surface.get()));
    cairo_scale(cr.get(), kPoints, kPoints);
    drawScene(cr.get(), scene, 0);
    cairo_show_page(cr.get());
    cairo_surface_finish(surface.get());
    const cairo_status_t status = cairo_surface_status(surface.get());
    if (status != CAIRO_STATUS_SUCCESS) return failure("PDF", status);
  }
  return bytes;
}

Result<std::string> writePng(const Scene& scene, const PngOptions& options) {
  const Status size = checkPage(scene);
  if (!size) return size.error();
  constexpr double kMostPixels = 30000;
  const double perMm = options.dpi / kInch;
  const double longest = std::max(scene.width, scene.height);
  if (!(perMm > 0)) return Error{ErrorCode::BadValue, "the resolution must be above 0 dpi", {}};
  if (std::ceil(longest * perMm) > kMostPixels) {
    return Error{ErrorCode::BadValue,
                 "at " + numberText(options.dpi, 0) +
                     " dpi the picture would be more than 30000 pixels long; " + "choose at most " +
                     numberText(std::floor(kMostPixels * kInch / longest), 0) + " dpi",
                 {}};
  }
  const int width = std::max(1, static_cast<int>(std::ceil(scene.width * perMm)));
  const int height = std::max(1, static_cast<int>(std::ceil(scene.height * perMm)));
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
    return failure("PNG", cairo_surface_status(surface.get()));
  }
  const CairoContext cr(cairo_create(surface.get()));
  // The last row and column of pixels reach beyond the page.
  if (scene.background) paintGround(cr.get(), *scene.background);
  cairo_scale(cr.get(), perMm, perMm);
  constexpr double kSeamPixels = 3;
  drawScene(cr.get(), scene, kSeamPixels / perMm);
  if (cairo_status(cr.get()) != CAIRO_STATUS_SUCCESS) return failure("PNG", cairo_status(cr.get()));
  return encodePng(pixelsOf(surface.get()), options.dpi);
}

}  // namespace kiri
