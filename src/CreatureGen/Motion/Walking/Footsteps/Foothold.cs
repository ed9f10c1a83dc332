using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>A place on the ground for a foot. World space, metres; on a moving platform it goes with it.</summary>
internal struct Foothold
{
    /// <summary>Under the ball.</summary>
    public Vector3 Position;

    /// <summary>Turn of the foot from the model's axes at rest, about up.</summary>
    public Quaternion Heading;

    /// <summary>Unit normal of the ground.</summary>
    public Vector3 Normal;

    /// <summary>What the ground is made of.</summary>
    public int Surface;

    /// <summary>The platform that it is on, 0 for none.</summary>
    public int Platform;

    /// <summary>How high the ground under the sole is in the mean above it, metres of the model: below 0 where its heel hangs over the edge that it came up, else 0. Bodies go by the ground and not by the edges that they climb.</summary>
    public float Below;

    /// <summary>Whether its toes hang over an edge: it does not roll over them.</summary>
    public bool Overhangs;

    /// <summary>How far a foot comes down here with its whole sole at once instead of its heel first, 0..1: all the way before a wall, and where its heel hangs over an edge or is in the air on bent ground.</summary>
    public float Whole;

    /// <summary>Whether an end of its sole is in a wall.</summary>
    public bool InWall;

    /// <summary>Whether its toes meet a wall, or one is right before them: it turns about the tip of them and does not roll on.</summary>
    public bool MeetsWall;

    private Vector3 localPosition;
    private Quaternion localHeading;
    private Vector3 localNormal;

    /// <summary>Yaw of the foot from the heading of a body, radians, small angles.</summary>
    public readonly float YawFrom(in RootPlace body)
    {
        Quaternion rotation = Rotation.Multiply(Rotation.Inverse(body.Rotation), Heading);
        return 2f * (rotation.W < 0f ? -rotation.Y : rotation.Y);
    }

    /// <summary>Comes from where a swing went before: it does not leap to another tread.</summary>
    /// <param name="before">The place before.</param>
    /// <param name="moved">How far what is asked for has moved since.</param>
    /// <param name="fraction">Share of the rest that is taken up.</param>
    public void Approach(in Foothold before, Vector3 moved, float fraction)
    {
        Vector3 from = before.Position + moved;
        Position = from + ((Position - from) * fraction);
        Below = before.Below + ((Below - before.Below) * fraction);
        Whole = before.Whole + ((Whole - before.Whole) * fraction);
        Normal = Vec.Normalize(Vec.Lerp(before.Normal, Normal, fraction), Normal);
    }

    /// <summary>Takes note of where the place is on its platform.</summary>
    public void Attach(IMovingGround? ground)
    {
        if (Platform == 0 || ground == null || !ground.TryLocate(Platform, out RootPlace at))
        {
            Platform = 0;
            return;
        }

        Quaternion inverse = Rotation.Inverse(at.Rotation);
        localPosition = at.ToModel(Position);
        localHeading = Rotation.Multiply(inverse, Heading);
        localNormal = Rotation.Rotate(inverse, Normal);
    }

    /// <summary>Goes with the platform to where it is now.</summary>
    public void Follow(IMovingGround ground)
    {
        if (Platform == 0)
        {
            return;
        }

        if (!ground.TryLocate(Platform, out RootPlace at))
        {
            Platform = 0;
            return;
        }

        Position = at.ToWorld(localPosition);
        Heading = Rotation.Normalize(Rotation.Multiply(at.Rotation, localHeading));
        Normal = Rotation.Rotate(at.Rotation, localNormal);
    }
}
