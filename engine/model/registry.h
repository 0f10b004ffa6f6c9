#pragma once
// The registry of tables: what of a model a later step depends on, each listed once. Beside the model, the owners
// of state are StepParts, Stepper, LoadSteps and Simulation (step/) and, for the files that a run writes, RunOutput
// (output/).
//
// Members are bound by position, so that a new one does not compile until it is placed here: as state, as a
// constant, or left out with the reason.
#include "model/model.h"
#include "model/state_visitor.h"

namespace talus {

void visit_state(Model& model, StateVisitor& visitor);
// The part of it that a script may change between steps: materials, joints, supports and loads.
void visit_values(Scene& scene, StateVisitor& visitor);
// What of its charges is no function: settled when the model is built.
void visit_charges(Scene& scene, StateVisitor& visitor);

void visit_state(BlockState& state, StateVisitor& visitor);
void visit_state(BlockShape& shape, StateVisitor& visitor);
void visit_state(QuadraticShape& shape, StateVisitor& visitor);
void visit_state(JointPoint& point, StateVisitor& visitor);
void visit_state(JointPoints& points, StateVisitor& visitor);
void visit_state(Bridge& bridge, StateVisitor& visitor);
void visit_state(Joint& joint, StateVisitor& visitor);
void visit_state(Contact& contact, StateVisitor& visitor);
void visit_state(Material& material, StateVisitor& visitor);
void visit_state(JointProperty& property, StateVisitor& visitor);
void visit_state(Strength& strength, StateVisitor& visitor);
void visit_state(On& on, StateVisitor& visitor);
void visit_state(Fixity& fixity, StateVisitor& visitor);
void visit_state(PointLoad& load, StateVisitor& visitor);
void visit_state(EdgeLoad& load, StateVisitor& visitor);
void visit_state(PointFixity& point, StateVisitor& visitor);
void visit_state(EdgeFixity& edge, StateVisitor& visitor);
void visit_state(PointForce& point, StateVisitor& visitor);
void visit_state(EdgeForce& edge, StateVisitor& visitor);
void visit_state(Region& region, StateVisitor& visitor);

}  // namespace talus
