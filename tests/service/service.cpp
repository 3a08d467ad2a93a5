#include "tests/service/service.h"

#include <fcntl.h>
#include <google/protobuf/text_format.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace trajan::test {

namespace {

constexpr const char* bar_text = R"scene(
  name: "bar"
  domain { dimension: PLANE_STRESS upper { x: 10.5 y: 1 } cell_size: 0.25 }
  materials { name: "elastic" density: 1 linear_elastic { youngs_modulus: 10000 } }
  bodies {
    name: "bar" material: "elastic"
    geometry { box { upper { x: 10 y: 1 } } }
    initial_velocity { x: "0.1 * sin(pi * x / 20)" }
  }
  boundaries { name: "wall" nodes { box { upper { y: 1 } } } fixed { axes: X } }
  outputs {
    snapshots: 4
    probes { name: "tip" nearest { x: 10 y: 0.5 } fields: DISPLACEMENT fields: VELOCITY }
  }
  measures { name: "tip" quantity: "tip.displacement.x" extreme {} }
)scene";

}  // namespace

TemporaryDirectory::TemporaryDirectory() {
  std::string name = (std::filesystem::temp_directory_path() / "trajan-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() { std::filesystem::remove_all(path_); }

Process::Process(const std::vector<std::string>& arguments) {
  std::vector<char*> pointers = {const_cast<char*>(TRAJAND)};
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("pipe");
  id_ = fork();
  if (id_ == 0) {
    dup2(ends[1], STDOUT_FILENO);
    execv(TRAJAND, pointers.data());
    _exit(127);
  }
  close(ends[1]);
  output_ = ends[0];
}

Process::~Process() {
  if (!ended_) {
    send(SIGKILL);
    wait();
  }
  close(output_);
}

void Process::send(int signal) const { kill(id_, signal); }

int Process::wait() {
  if (ended_) return result_;
  int status = 0;
  waitpid(id_, &status, 0);
  ended_ = true;
  result_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return result_;
}

std::string Process::read_line() {
  std::string line;
  char character = 0;
  while (read(output_, &character, 1) == 1 && character != '\n') line += character;
  return line;
}

Service::Service(std::vector<std::string> options) : options_(std::move(options)) { restart(); }

void Service::restart() {
  std::vector<std::string> arguments = {"serve",          "--state",     state().string(),
                                        "--no-calibrate", "--log-level", "warning"};
  if (std::ranges::find(options_, "--workers") == options_.end()) {
    arguments.insert(arguments.end(), {"--workers", "1"});
  }
  arguments.insert(arguments.end(), options_.begin(), options_.end());
  server_ = std::make_unique<Process>(arguments);
  const std::string ready = server_->read_line();
  const std::string prefix = "listening on ";
  if (!ready.starts_with(prefix)) throw std::runtime_error("the server did not start");
  channel_ = grpc::CreateChannel(ready.substr(prefix.size()), grpc::InsecureChannelCredentials());
  jobs_ = v1::Jobs::NewStub(channel_);
  studies_ = v1::Studies::NewStub(channel_);
}

Service::~Service() {
  server_.reset();
  for (const pid_t worker : workers()) kill(worker, SIGKILL);
  eventually([&] { return workers().empty(); });
}

std::vector<pid_t> Service::workers() const {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream file(entry.path() / "cmdline", std::ios::binary);
    // Reading fails softly if the process ends meanwhile.
    std::string command;
    std::getline(file, command, '\n');
    const bool ours = command.find(state().string() + "/") != std::string::npos;
    if (ours && command.find("--worker-id") != std::string::npos) found.push_back(std::stoi(name));
  }
  return found;
}

std::string Service::submit(const v1::Scene& scene) {
  v1::SubmitJobRequest request;
  *request.mutable_scene() = scene;
  grpc::ClientContext context;
  v1::Job job;
  const grpc::Status status = jobs_->SubmitJob(&context, request, &job);
  if (!status.ok()) throw std::runtime_error("submit: " + status.error_message());
  return job.job_id();
}

std::string Service::sweep(const v1::Scene& scene, const std::vector<double>& shares) {
  v1::SubmitStudyRequest request;
  *request.mutable_scene() = scene;
  v1::Dial& dial = *request.mutable_sweep()->add_dials();
  dial.set_name("share");
  for (const double share : shares) {
    v1::Setting& setting = *dial.add_settings();
    setting.set_name(std::to_string(share));
    setting.add_changes("analysis.end_time=" + std::to_string(share * scene.analysis().end_time()));
  }
  grpc::ClientContext context;
  v1::Job job;
  const grpc::Status status = studies_->SubmitStudy(&context, request, &job);
  if (!status.ok()) throw std::runtime_error("submit: " + status.error_message());
  return job.job_id();
}

v1::Study Service::study(const std::string& job) {
  v1::GetStudyRequest request;
  request.set_job_id(job);
  grpc::ClientContext context;
  v1::Study study;
  const grpc::Status status = studies_->GetStudy(&context, request, &study);
  if (!status.ok()) throw std::runtime_error("study: " + status.error_message());
  return study;
}

v1::Job Service::get(const std::string& job) {
  v1::GetJobRequest request;
  request.set_job_id(job);
  grpc::ClientContext context;
  v1::Job found;
  const grpc::Status status = jobs_->GetJob(&context, request, &found);
  if (!status.ok()) throw std::runtime_error("get: " + status.error_message());
  return found;
}

grpc::Status Service::watch(const std::string& job, std::vector<v1::Event>& events, v1::Job& last,
                            const std::function<bool(const v1::WatchJobResponse&)>& enough) {
  v1::WatchJobRequest request;
  request.set_job_id(job);
  request.set_after_sequence(events.empty() ? 0 : events.back().sequence());
  grpc::ClientContext context;
  const auto stream = jobs_->WatchJob(&context, request);
  v1::WatchJobResponse response;
  while (stream->Read(&response)) {
    if (response.has_job()) last = response.job();
    if (response.has_event()) events.push_back(response.event());
    if (enough && enough(response)) context.TryCancel();
  }
  return stream->Finish();
}

v1::Job Service::wait(const std::string& job) {
  std::vector<v1::Event> events;
  v1::Job last;
  eventually([&] { return watch(job, events, last).ok(); });
  return last;
}

void Service::wait_for_checkpoint(const std::string& job) {
  std::vector<v1::Event> events;
  v1::Job last;
  const auto checkpoint = job_directory(job) / "checkpoint.h5";
  const auto status = watch(job, events, last, [&](const auto&) { return std::filesystem::exists(checkpoint); });
  if (status.ok()) throw std::runtime_error("the job ended before it wrote a checkpoint");
}

std::vector<double> Service::history(const std::string& job, bool follow) {
  v1::StreamHistoryRequest request;
  request.set_job_id(job);
  request.set_follow(follow);
  grpc::ClientContext context;
  const auto stream = jobs_->StreamHistory(&context, request);
  v1::StreamHistoryResponse response;
  std::vector<double> values;
  std::int64_t rows = 0;
  while (stream->Read(&response)) {
    if (response.first_row() != rows) throw std::runtime_error("rows are missing or repeated");
    rows += response.time_size();
    values.insert(values.end(), response.values().begin(), response.values().end());
  }
  const grpc::Status status = stream->Finish();
  if (!status.ok()) throw std::runtime_error("history: " + status.error_message());
  return values;
}

double slowness() {
#ifdef TRAJAN_SANITIZED_THREADS
  return 50;
#elif defined(TRAJAN_SANITIZED)
  return 10;
#else
  return 1;
#endif
}

v1::Scene bar(double length, int samples) {
  v1::Scene scene;
  const bool parsed = google::protobuf::TextFormat::ParseFromString(bar_text, &scene);
  if (!parsed) throw std::logic_error("the test's scene is not a scene");
  scene.mutable_analysis()->set_end_time(40 / slowness() * length);
  scene.mutable_outputs()->set_samples(samples);
  return scene;
}

bool eventually(const std::function<bool()>& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

v1::ErrorDetails details(const grpc::ClientContext& context) {
  v1::ErrorDetails found;
  const auto& metadata = context.GetServerTrailingMetadata();
  const auto entry = metadata.find("trajan-error-bin");
  if (entry != metadata.end()) found.ParseFromArray(entry->second.data(), static_cast<int>(entry->second.size()));
  return found;
}

}  // namespace trajan::test
