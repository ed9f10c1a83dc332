using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>How far a creature went in a step.</summary>
/// <param name="Shift">Metres, in its axes at the beginning of the step.</param>
/// <param name="Turn">Radians about its +Y; positive turns left.</param>
public readonly record struct RootDelta(Vector3 Shift, float Turn)
{
    /// <summary>The place after the step: this is root motion driven by the animation.</summary>
    /// <param name="place">Before the step. Its scale makes the shift larger, too.</param>
    public RootPlace From(in RootPlace place) => new(
        place.ToWorld(Shift),
        Rotation.Normalize(Rotation.Multiply(place.Rotation, Rotation.FromAxisAngle(Vector3.UnitY, Turn))),
        place.Scale);
}
