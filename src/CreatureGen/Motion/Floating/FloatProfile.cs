using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Floating;

/// <summary>What follows from the build of a body on legs for how it floats and paddles: how deep it lies in the water, how its trunk is held, in which order its legs go. Immutable.</summary>
/// <remarks>Times go with τ = √(ℓ/g). Based on: Catavitello, Ivanenko and Lacquaniti 2015 (dogs paddle at 1.5 to 1.7 Hz, diagonal legs nearly together).</remarks>
internal sealed class FloatProfile
{
    /// <summary>Part of the trunk's height that is under water: of upright bodies as they lie ahead, and of any body at least.</summary>
    private const float UprightImmersion = 0.9f;
    private const float MinImmersion = 0.3f;

    /// <summary>Radians by which the trunk of a body on two legs rises ahead as it lies on the water: what stands more upright lies ahead by the rest.</summary>
    private const float LyingRise = 0.35f;

    /// <summary>Radians by which a trunk is held nose up at least and at most; an upright one lies ahead on the water by so much at most.</summary>
    private const float MinPitch = 0.08f;
    private const float SteepestPitch = 0.4f;
    private const float UprightLean = 1.1f;

    /// <summary>How far the middle of the head is to be above the surface, its radii.</summary>
    private const float HeadRoom = 0.5f;

    /// <summary>Radians by which a neck raises its head at most.</summary>
    private const float HighestNeck = 0.5f;

    /// <summary>Part of a cycle by which each further pair of legs is later: diagonal ones nearly together on four, a wave along more.</summary>
    private const float FourLeggedLag = 0.42f;
    private const float WaveLag = 0.2f;

    private readonly float[] lags;

    private FloatProfile(LeggedBody body)
    {
        Body = body;
        ReadOnlySpan<Vector3> rest = body.TrunkRest;
        Vector3 line = rest[rest.Length - 1] - rest[0];
        float lean = body.IsBiped ? Scalar.Clamp((float)PortableMath.Asin(Math.Max(line.Y, 0f) / Vec.Length(line)) - LyingRise, 0f, UprightLean) : 0f;
        Extent(body, body.Trunk, Vector3.Zero, 0f, out Vector3 min, out Vector3 max);
        Middle = (min + max) * 0.5f;
        LegStep step = body.Legs[0].Traits.Kind.Step;
        Undulation = step.Undulation;
        LiesAhead = lean > 0f;
        Extent(body, body.Trunk, Middle, lean, out min, out max);
        float immersion = Scalar.Lerp(step.Immersion, UprightImmersion, lean / UprightLean);
        Draught = Math.Max(Math.Min(Scalar.Lerp(min.Y, max.Y, immersion), HeadHeight(body, Middle, lean)), Scalar.Lerp(min.Y, max.Y, MinImmersion));
        (Pitch, NeckPitch) = LiesAhead ? (-lean, -lean) : PitchOf(body);
        lags = Array.ConvertAll(body.Legs, leg => LagOf(body, leg));
    }

    /// <summary>The body.</summary>
    public LeggedBody Body { get; }

    /// <summary>Height of the surface above the root where it floats at rest, metres of the model.</summary>
    public float Draught { get; }

    /// <summary>Middle of the trunk at rest, about which it is pitched, model space.</summary>
    public Vector3 Middle { get; }

    /// <summary>How far the trunk is held nose up, radians; negative where it leans ahead.</summary>
    public float Pitch { get; }

    /// <summary>How far the neck is bent down from there, radians; negative where it raises the head.</summary>
    public float NeckPitch { get; }

    /// <summary>Whether it is an upright body, which lies ahead on the water and paddles with its arms too.</summary>
    public bool LiesAhead { get; }

    /// <summary>How far its tail waves to either side, radians from its root to its tip.</summary>
    public float Undulation { get; }

    /// <summary>Part of a cycle by which a leg is later than the left hind one.</summary>
    public float LagOf(int leg) => lags[leg];

    /// <summary>Works it out.</summary>
    public static FloatProfile Of(LeggedBody body) => new(body);

    /// <summary>Height of the middle of the head of a body that leans: whose head is low swims before it is under water.</summary>
    private static float HeadHeight(LeggedBody body, Vector3 about, float lean)
    {
        if (body.Neck.Length == 0)
        {
            return float.MaxValue;
        }

        Extent(body, body.Neck.AsSpan(body.Neck.Length - 1), about, lean, out Vector3 min, out Vector3 max);
        return 0.5f * (min.Y + max.Y);
    }

    /// <summary>So steeply that the head is out of the water; and the neck takes back as much of that as leaves the head there, or raises it.</summary>
    private (float Trunk, float Neck) PitchOf(LeggedBody body)
    {
        if (body.Neck.Length == 0)
        {
            return (MinPitch, 0f);
        }

        Extent(body, body.Neck.AsSpan(body.Neck.Length - 1), Vector3.Zero, 0f, out Vector3 min, out Vector3 max);
        Vector3 head = (min + max) * 0.5f;
        float ahead = Math.Max(head.Z - Middle.Z, 0.1f * body.LegLength);
        float surface = Draught + (HeadRoom * 0.5f * (max.Y - min.Y));
        float pitch = Scalar.Clamp((surface - head.Y) / ahead, MinPitch, SteepestPitch);
        float spare = (head.Y + (ahead * pitch) - surface) / body.NeckLength;
        return (pitch, Scalar.Clamp(spare, -HighestNeck, pitch));
    }

    /// <summary>Frogs push both legs of a pair at once.</summary>
    private static float LagOf(LeggedBody body, LegRig leg)
    {
        float side = leg.Side == Side.Left || body.Leaps ? 0f : 0.5f;
        float lag = side + (leg.Row * (body.Rows == 2 ? FourLeggedLag : WaveLag));
        return lag - (float)Math.Floor(lag);
    }

    /// <summary>Room that the flesh of some joints takes at rest, leant ahead about a place by an angle.</summary>
    private static void Extent(LeggedBody body, ReadOnlySpan<int> joints, Vector3 about, float lean, out Vector3 min, out Vector3 max)
    {
        Quaternion turn = AxisRotation.Pitch(lean);
        Skeleton skeleton = body.Skeleton;
        min = new Vector3(float.MaxValue);
        max = new Vector3(float.MinValue);
        foreach (CapsuleCollider bone in body.Subject.Bones)
        {
            if (joints.IndexOf(bone.Joint) >= 0)
            {
                Include(skeleton, bone, bone.Start, about, turn, ref min, ref max);
                Include(skeleton, bone, bone.End, about, turn, ref min, ref max);
            }
        }

        foreach (int joint in joints)
        {
            Vector3 place = about + Rotation.Rotate(turn, skeleton.ModelPositions[joint] - about);
            min = Vec.Min(min, place);
            max = Vec.Max(max, place);
        }
    }

    private static void Include(Skeleton skeleton, in CapsuleCollider bone, Vector3 end, Vector3 about, Quaternion turn, ref Vector3 min, ref Vector3 max)
    {
        Vector3 place = skeleton.ModelPositions[bone.Joint] + Rotation.Rotate(skeleton.ModelRotations[bone.Joint], end);
        place = about + Rotation.Rotate(turn, place - about);
        var radius = new Vector3(bone.Radius);
        min = Vec.Min(min, place - radius);
        max = Vec.Max(max, place + radius);
    }
}
