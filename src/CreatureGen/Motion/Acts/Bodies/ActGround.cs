using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Footsteps;

namespace CreatureGen.Motion.Acts.Bodies;

/// <summary>The ground that a creature performs on, as a plane, model space: the one that its feet stand on.</summary>
/// <param name="Point">A point of it.</param>
/// <param name="Normal">Unit, away from the ground.</param>
internal readonly record struct ActGround(Vector3 Point, Vector3 Normal)
{
    /// <summary>Level, at the height of the root.</summary>
    public static ActGround Level => new(Vector3.Zero, Vector3.UnitY);

    /// <summary>The mean of the places of feet.</summary>
    /// <param name="feet">Of a creature that stands.</param>
    /// <param name="root">Where it is.</param>
    public static ActGround Under(ReadOnlySpan<Foot> feet, in RootPlace root)
    {
        Vector3 sum = Vector3.Zero;
        Vector3 normal = Vector3.Zero;
        foreach (ref readonly Foot foot in feet)
        {
            sum += root.ToModel(foot.Plan.From.Position);
            normal += Rotation.Rotate(Rotation.Inverse(root.Rotation), foot.Plan.From.Normal);
        }

        return feet.Length == 0 ? Level : new(sum / feet.Length, Vec.Normalize(normal, Vector3.UnitY));
    }

    /// <summary>How high a place is above it, metres; negative within.</summary>
    public float HeightOf(Vector3 place) => Vec.Dot(place - Point, Normal);
}
