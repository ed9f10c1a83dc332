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
    /// <summary>How much what feet stand on counts beside where they are, part of how far they are apart, squared.</summary>
    private const float Underfoot = 0.01f;

    /// <summary>How far up the normal of what feet stand on points at the least: a wall leads nowhere.</summary>
    private const float Steepest = 0.2f;

    /// <summary>Level, at the height of the root.</summary>
    public static ActGround Level => new(Vector3.Zero, Vector3.UnitY);

    /// <summary>Through the places of feet, as nearly as a plane can be: treads of stairs are level, and what stands on several of them is on a slope. Where feet are beside one another only it goes on as what they stand on.</summary>
    /// <param name="feet">Of a creature that stands.</param>
    /// <param name="root">Where it is.</param>
    public static ActGround Under(ReadOnlySpan<Foot> feet, in RootPlace root)
    {
        if (feet.Length == 0)
        {
            return Level;
        }

        Vector3 middle = Vector3.Zero;
        Vector3 underfoot = Vector3.Zero;
        foreach (ref readonly Foot foot in feet)
        {
            middle += root.ToModel(foot.Plan.From.Position);
            underfoot += Rotation.Rotate(Rotation.Inverse(root.Rotation), foot.Plan.From.Normal);
        }

        middle /= feet.Length;
        return new ActGround(middle, Through(feet, root, middle, Vec.Normalize(underfoot, Vector3.UnitY)));
    }

    /// <summary>How high a place is above it, metres; negative within.</summary>
    public float HeightOf(Vector3 place) => Vec.Dot(place - Point, Normal);

    /// <summary>The normal of the plane through a point that is nearest to feet (least squares), and to what they stand on where they do not tell.</summary>
    private static Vector3 Through(ReadOnlySpan<Foot> feet, in RootPlace root, Vector3 middle, Vector3 underfoot)
    {
        float across = 0f;
        float along = 0f;
        float both = 0f;
        float riseAcross = 0f;
        float riseAlong = 0f;
        foreach (ref readonly Foot foot in feet)
        {
            Vector3 away = root.ToModel(foot.Plan.From.Position) - middle;
            across += away.X * away.X;
            along += away.Z * away.Z;
            both += away.X * away.Z;
            riseAcross += away.X * away.Y;
            riseAlong += away.Z * away.Y;
        }

        float told = Underfoot * (across + along);
        across += told;
        along += told;
        told /= Math.Max(underfoot.Y, Steepest);
        riseAcross -= told * underfoot.X;
        riseAlong -= told * underfoot.Z;
        float size = (across * along) - (both * both);
        return size > 0f
            ? Vec.Normalize(new Vector3(((both * riseAlong) - (along * riseAcross)) / size, 1f, ((both * riseAcross) - (across * riseAlong)) / size), underfoot)
            : underfoot;
    }
}
