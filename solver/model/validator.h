#pragma once

#include "solver/model/checks.h"

namespace trajan {

/// Checks a scene part by part and builds the Model on the way. Each part has its own source file,
/// validate_<part>.cpp. A part that depends on another is checked as far as the other was right.
class Validator : private Checks {
 public:
  explicit Validator(const Scene& scene) : Checks(scene) {}
  Model run();

 private:
  void check_head();
  void check_constants();
  void check_domain();
  void check_extent();
  void check_grid(const std::string& path);
  void check_materials();
  void check_use(const std::string& path, const MaterialKind& kind);
  void check_law(const std::string& path, const MaterialDefinition& definition, Material& material);
  bool read_parameters(const std::string& path, std::span<const Parameter> table,
                       const std::map<std::string, double>& values, Material& material);
  /// Makes the material's law the same with damage.
  bool add_damage(const std::string& path, const std::map<std::string, double>& values, Material& material);
  void check_law_as_a_whole(const std::string& path, const std::string& law_path, const Material& material);
  bool check_parameter(const std::string& path, const Parameter& parameter, double value);
  void check_bodies();
  bool check_body(const std::string& path, const BodyDefinition& definition, Body& body);
  void check_initial_state(const std::string& path, const BodyDefinition& definition, Body& body, Vector place);
  void check_initial_stress(const std::string& path, const BodyDefinition& definition, Body& body, Vector place);
  void check_initial_deformation(const std::string& path, const BodyDefinition& definition, Body& body,
                                 Vector place);
  void check_volume_ratio(const std::string& path, Body& body);
  const MaterialKind* law_of(const Body& body) const;  ///< nullptr: not known
  bool too_many(const std::string& path, double particles);
  bool fill_body(const std::string& path, const BodyDefinition& definition, Body& body);
  bool check_gauss_layout(const std::string& path, const BodyDefinition& definition);
  std::string box_text(const Box& box) const;
  void check_boundaries();
  void check_contacts();
  void check_boundary(const std::string& path, const BoundaryDefinition& definition);
  /// Says which axes are periodic before other conditions are looked at.
  void check_periods();
  void check_period(const std::string& path, Axis axis);
  bool is_periodic(int axis) const { return model_.grid.periodic[static_cast<std::size_t>(axis)]; }
  bool is_empty(const std::string& path, const NodeRegion& nodes);
  template <class Kind>
  void add(const BoundaryDefinition& definition, Kind kind);
  NodeRegion check_nodes(const std::string& path, const BoundaryDefinition& definition);
  void refuse_nodes(const std::string& path, const BoundaryDefinition& definition, const std::string& condition);
  bool check_face(const std::string& path, Edge face);
  /// Where the domain repeats itself there is no face.
  void check_solid_face(const std::string& path, Edge face);
  bool check_axis(const std::string& path, Axis axis);
  std::array<bool, 3> check_axes(const std::string& path, const std::vector<Axis>& given);
  PrescribedMotion check_fixed(const std::string& path, const BoundaryDefinition& definition, const Fixed& fixed);
  PrescribedMotion check_roller(const std::string& path, const BoundaryDefinition& definition,
                                const Roller& roller);
  PrescribedMotion check_symmetry(const std::string& path, const Symmetry& symmetry);
  PrescribedMotion check_motion(const std::string& path, const BoundaryDefinition& definition,
                                const std::string& field, const VectorExpression& formulas, bool displacement);
  RigidObstacle check_contact(const std::string& path, const Contact& contact);
  RigidObstacle check_plane(const std::string& path, const RigidPlane& plane);
  RigidObstacle check_ball(const std::string& path, const RigidBall& ball);
  HeldSurface check_hinge(const std::string& path, const Hinge& hinge);
  AbsorbingSurface check_absorbing(const std::string& path, const Absorbing& absorbing);
  std::vector<SurfacePoint> check_surface(const std::string& path, const Surface& surface);
  std::vector<SurfacePoint> check_edge(const std::string& path, const std::string& name,
                                       std::optional<std::size_t> body, Edge edge);
  std::vector<SurfacePoint> check_rim(const std::string& path, std::optional<std::size_t> body, const Disc& rim);
  int surface_normal(const std::string& path, const Surface& surface);
  void check_loads();
  void check_load(const std::string& path, const LoadDefinition& definition);
  std::vector<LoadPoint> load_points(const std::string& path, const PointForce& force);
  std::vector<LoadPoint> load_points(const std::string& path, const EdgeTraction& traction);
  std::vector<LoadPoint> load_points(const std::string& path, const Pressure& pressure);
  /// The points with their areas times a profile.
  std::vector<std::pair<SurfacePoint, double>> with_profile(const std::string& path, const std::string& profile,
                                                            const std::vector<SurfacePoint>& points);
  BodyLoad body_load(const std::string& path, const BodyForce& force);
  std::optional<TimeFunction> time_function(const std::string& path, const TimeFunctionDefinition& definition);
  void check_analysis();
  void check_kind(const ExplicitDynamics&) {}
  void check_kind(const Relaxation& analysis);
  void check_kind(const QuasiStatic& analysis);
  void check_kind(const ImplicitDynamics& analysis);
  void check_kind(const Modal& analysis);
  void check_kind(const Buckling&);
  void check_modes();
  void check_implicit_choices();
  void check_statics();
  void check_mass(const std::string& path, MassMatrix mass);
  void check_newton(const std::string& path, const Newton& newton);
  void check_numerics();
  void check_combinations();
  void check_rigid_bodies_at_rest();
  void check_transfer();
  void check_time_step();
  void check_outputs();
  bool check_fields(const std::string& path, const std::vector<Field>& fields);
  /// Names of history variables that the laws of all these bodies have, or of some of them.
  bool check_history(const std::string& path, const std::vector<std::string>& history,
                     const std::vector<std::size_t>& bodies, bool in_all);
  /// Empty as well if the body's law is wrong.
  std::span<const HistoryVariable> history_of(const Body& body) const;
  /// Which history variable of the body's law has this name; -1: none.
  int history_place(const Body& body, const std::string& name) const;
  std::vector<RecordedField> recorded_fields(const std::vector<Field>& fields,
                                             const std::vector<std::string>& history) const;
  void check_snapshot_fields();
  void check_reactions();
  void check_contact_force(const std::string& path, const std::string& name, std::size_t body);
  void check_snapshots();
  void check_probe(const std::string& path, const ProbeDefinition& definition);
  std::vector<std::int64_t> nearest(const std::string& path, Vector place, const std::vector<std::size_t>& bodies);
  std::vector<std::int64_t> within_region(const std::string& path, const Region& region,
                                          const std::vector<std::size_t>& bodies);
  void check_measures();
  void check_measure(const std::string& path, const MeasureDefinition& definition);
  void check_window(const std::string& path, const MeasureDefinition& definition, Measure& measure);
  void check_frequency(const std::string& path, const DominantFrequency& frequency);
  void check_exact(const std::string& path, const MeasureDefinition& definition, Measure& measure);
};

}  // namespace trajan
