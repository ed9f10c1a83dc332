using System.Numerics;

namespace CreatureGen.Events;

/// <summary>Where the end of a limb is, in parts of its length at rest; directions of model space.</summary>
/// <param name="About">From where the limb begins; of a joint alone the unit direction of its bone.</param>
/// <param name="Through">From the model.</param>
internal readonly record struct SweepEnd(Vector3 About, Vector3 Through);
