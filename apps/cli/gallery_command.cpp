// kiri gallery: a page of models with pictures, films, step sheets and downloads.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/cli/commands.h"
#include "apps/cli/gallery_entry.h"
#include "apps/cli/gallery_page.h"
#include "apps/cli/gallery_plan.h"
#include "apps/cli/worker_pool.h"
#include "io/examples_folder.h"
#include "io/file.h"
#include "render/film/child.h"

namespace kiri::cli {

namespace {

struct GalleryCommandOptions {
  std::vector<std::string> models;
  GalleryOptions gallery;
  bool hasNoAnimations = false;
  std::size_t threads = 0;  ///< 0: as many as the machine runs at once
};

/// One model's work, and what was said while it was done.
struct GalleryJob {
  std::string file;
  std::string said;
  Result<GalleryEntryFiles> entry = Error{ErrorCode::Cancelled, "", {}};
};

std::vector<GalleryJob> jobsOf(const GalleryPlan& plan) {
  std::vector<GalleryJob> jobs;
  for (const GalleryPlanGroup& group : plan.groups) {
    for (const std::string& file : group.files) jobs.emplace_back().file = file;
  }
  return jobs;
}

/// Told before any work is done: where the pages go, and what makes the films.
Status checkPlace(const GalleryOptions& options) {
  std::error_code error;
  std::filesystem::create_directories(options.out, error);
  if (error) return Error{ErrorCode::Unwritable, options.out + ": " + error.message()};
  if (!options.hasAnimations) return std::monostate{};
  Result<Child> ffmpeg = Child::start({"ffmpeg", "-nostdin", "-loglevel", "error", "-version"});
  Status runs = ffmpeg ? ffmpeg->finish() : Status(ffmpeg.error());
  if (runs) return runs;
  return Error{ErrorCode::Unwritable,
               "films are made by the program ffmpeg, which is not installed or does not run "
               "(Debian: apt-get install ffmpeg); --no-animations leaves films out"};
}

void doJob(Console& console, const GalleryOptions& options, const std::atomic<bool>& stop,
           GalleryJob& job) {
  std::ostringstream said;
  Console own{console.in, said, said, false, [&stop] { return stop.load(); }};
  const Result<ModelInput> input = loadModel(own, job.file);
  job.entry = input ? writeGalleryEntry(own, *input, options) : input.error();
  job.said = said.str();
}

std::string wordsFor(const PoolView& view, const std::vector<GalleryJob>& jobs) {
  std::string words = std::to_string(view.done) + " of " + std::to_string(jobs.size());
  for (std::size_t i = 0; i < view.atWork.size(); ++i) {
    words += (i == 0 ? ": " : ", ") + galleryFolderOf(jobs[view.atWork[i]].file);
  }
  return words;
}

/// Does the work. A place that cannot be written to ends it, a model that fails does not.
void doJobs(Console& console, const GalleryCommandOptions& options, std::vector<GalleryJob>& jobs) {
  ProgressLine line(console, "gallery");
  std::atomic<bool> isUnwritable{false};
  const auto work = [&](std::size_t i, const std::atomic<bool>& stop) {
    doJob(console, options.gallery, stop, jobs[i]);
    if (!jobs[i].entry && jobs[i].entry.error().code == ErrorCode::Unwritable) isUnwritable = true;
  };
  inParallel(
      jobs.size(), options.threads > 0 ? options.threads : processorCount(), work,
      [&](const PoolView& view) { return line.tell(wordsFor(view, jobs)) && !isUnwritable; });
}

/// Says what was said at work, and what failed. How many models are done.
std::size_t reportJobs(Console& console, const std::vector<GalleryJob>& jobs) {
  std::size_t done = 0;
  for (const GalleryJob& job : jobs) {
    console.err << job.said;
    if (job.entry) {
      ++done;
    } else if (job.entry.error().code != ErrorCode::Cancelled) {
      fail(console, job.entry.error());
    }
  }
  return done;
}

GalleryPages pagesOf(const GalleryPlan& plan, const std::vector<GalleryJob>& jobs) {
  GalleryPages pages{plan.title, {}};
  std::size_t next = 0;
  for (const GalleryPlanGroup& group : plan.groups) {
    GalleryPageGroup shown{group.title, group.notes, {}};
    for (std::size_t i = 0; i < group.files.size(); ++i, ++next) {
      if (jobs[next].entry) shown.entries.push_back(*jobs[next].entry);
    }
    if (!shown.entries.empty()) pages.groups.push_back(std::move(shown));
  }
  return pages;
}

Status writePages(const GalleryPages& pages, const std::string& out) {
  for (std::size_t g = 0; g < pages.groups.size(); ++g) {
    const std::vector<GalleryEntryFiles>& entries = pages.groups[g].entries;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      Status status =
          writeFile(out + "/" + entries[i].folder + "/index.html", galleryPage(pages, g, i));
      if (!status) return status;
    }
  }
  return writeFile(out + "/index.html", galleryIndex(pages));
}

int finish(Console& console, const GalleryPlan& plan, const std::vector<GalleryJob>& jobs,
           const std::string& out) {
  const std::size_t done = reportJobs(console, jobs);
  const std::string count = std::to_string(done) + " of " + std::to_string(jobs.size());
  const auto isOf = [](ErrorCode code) {
    return [code](const GalleryJob& job) { return !job.entry && job.entry.error().code == code; };
  };
  if (std::any_of(jobs.begin(), jobs.end(), isOf(ErrorCode::Unwritable))) return kCannotWrite;
  if (std::any_of(jobs.begin(), jobs.end(), isOf(ErrorCode::Cancelled))) {
    return fail(console, kCancelled,
                "stopped; the pictures of " + count + " models are in " + out +
                    ", the pages were not written");
  }
  if (done > 0) {
    const Status status = writePages(pagesOf(plan, jobs), out);
    if (!status) return fail(console, status.error());
  }
  if (done == jobs.size()) return kDone;
  return fail(console, kBadModel,
              done > 0 ? "the pages show " + count + " models; mend the others and run it again"
                       : "no model could be shown, no pages were written");
}

int run(Console& console, GalleryCommandOptions options) {
  options.gallery.hasAnimations = !options.hasNoAnimations;
  const Result<GalleryPlan> plan =
      galleryPlanOf(console, options.models, examplesFolder(console.programFolder));
  if (!plan) return fail(console, plan.error(), kBadUsage);
  const Status place = checkPlace(options.gallery);
  if (!place) return fail(console, place.error());
  std::vector<GalleryJob> jobs = jobsOf(*plan);
  doJobs(console, options, jobs);
  return finish(console, *plan, jobs, options.gallery.out);
}

}  // namespace

void addGalleryCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command =
      app.add_subcommand("gallery", "Make a page of models with pictures, films and downloads");
  const auto options = std::make_shared<GalleryCommandOptions>();
  command->add_option("MODELS", options->models,
                      "models, folders of them, or galleries (gallery.json); none: the examples");
  command->add_option("-o,--output", options->gallery.out, "folder to write into")
      ->type_name("DIR")
      ->required();
  command->add_flag("--no-animations", options->hasNoAnimations,
                    "leave out the films, which need ffmpeg");
  command
      ->add_option("--threads", options->threads,
                   "models that are worked on at a time (default: what the machine has)")
      ->type_name("N")
      ->check(CLI::Range(1, 256));
  command->footer(
      "Writes DIR/index.html and a folder for each model. The pages need no server.\n"
      "A folder's gallery.json says which models are shown, in which groups; without one all\n"
      "its .kiri files are. A model that fails is named, and the others are shown.\n\n"
      "Examples:\n"
      "  kiri gallery -o gallery\n"
      "  kiri gallery my-models -o gallery\n"
      "  kiri gallery leaf.kiri ship.kiri -o gallery --no-animations");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
