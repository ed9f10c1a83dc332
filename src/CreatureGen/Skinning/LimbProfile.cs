using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>
/// How one appendage shares its skin among its joints and the body, as functions of the path length from the socket (0..1) and, in the foot, of the height.
/// </summary>
/// <remarks>
/// <para>The limb's first joint holds <see cref="rootFraction"/> of the skin at the socket's border and all of it from a little way down; the rest stays with the bones of the body that move
/// the border where the vertex grew from, and with the girdle.
/// From joint to joint the skin of legs goes over by smoothstep, that of all else evenly, within a stretch on either side that never exceeds 0.6 of the shorter segment. Blended turns are quickest in the middle
/// of a stretch: where a wing folds, an even share crowds the fewest of its triangles.</para>
/// <para>Soles: below about half the height of the ankle a flat foot is one piece with the ankle, and what lies ahead of its ball is one with the toes; else soles sink when feet roll.</para>
/// </remarks>
internal sealed class LimbProfile
{
    /// <summary>Share of the girdle in what a leg does not hold itself.</summary>
    private const float GirdleFraction = 0.45f;

    /// <summary>Largest half width of a change of joint, in lengths of the shorter segment.</summary>
    private const float WidestStretch = 0.6f;

    /// <summary>The same at the ball of a foot, where heels and hind toes would sink as it rolls.</summary>
    private const float WidestAtBall = 0.45f;

    // By which share of its span farther out a membrane is all its own at the trailing edge, what part of the skin at its root the flank holds there beside the leading edge, and in which part of the stretch at its root it lets none of that go where wings are not folded: it grows along the flank, and what turned with the arm stood up as spikes where it folds.
    private const float HeldByFlank = 0.15f;
    private const float HeldAtRoot = 0.7f;
    private const float HeldAlong = 0.8f;

    private const int Ball = 3;

    private readonly Appendage appendage;
    private readonly int[] joints;
    private readonly float[] stretch;
    private readonly float[] along;
    private readonly float rootFraction;
    private readonly float rootEnd;
    private readonly JointCrease?[] creases;
    private readonly bool legged;
    private readonly bool flat;
    private readonly bool rigidSole;
    private readonly bool hasToes;

    public LimbProfile(Appendage appendage, AppendageJoints joints, Skeleton skeleton)
    {
        this.appendage = appendage;
        this.joints = joints.Left;
        along = appendage.JointsAlong;
        legged = appendage.Kind is LimbKind.Leg or LimbKind.Arm;
        LimbArchetype? archetype = appendage.Archetype;
        LegOutline? outline = archetype is { } kind ? LegKinds.Of(kind).Outline : null;
        flat = appendage.Stands && outline is { FlatSoled: true };
        rigidSole = outline is { End: FootEnd.Pad };
        hasToes = !rigidSole;
        stretch = new float[along.Length];
        bool insect = outline is { Jointed: true };
        float[] half = insect ? new[] { 0f, 0.03f, 0.03f, 0.02f }
            : legged ? new[] { 0f, 0.08f, 0.08f, 0.03f }
            : appendage.Kind == LimbKind.Wing ? new[] { 0f, 0.15f, 0.15f, 0.15f }
            : new[] { 0f, appendage.Kind == LimbKind.Ear ? 0.2f : 0.25f };
        for (int k = 1; k < along.Length - 1; k++)
        {
            float before = along[k] - along[k - 1];
            float after = Math.Max(along[k + 1] - along[k], 0.02f);
            float widest = legged && k == Ball ? WidestAtBall : WidestStretch;
            stretch[k] = Math.Min(half[Math.Min(k, half.Length - 1)], widest * Math.Min(before, after));
        }

        (rootFraction, rootEnd, Border) = appendage.Kind switch
        {
            LimbKind.Leg or LimbKind.Arm when insect => (1f, 0.01f, new float[SocketSpread.Rings]),
            LimbKind.Leg or LimbKind.Arm => (0.30f, along[1], new[] { 0.30f, 0.14f, 0.05f }),
            LimbKind.Wing => (0.35f, 0.10f, new[] { 0.30f, 0.12f, 0.04f }),
            LimbKind.Ear => (0.25f, 0.25f, new[] { 0.20f, 0.06f, 0f }),
            LimbKind.InsectWing or LimbKind.Pectoral or LimbKind.Dorsal or LimbKind.Ventral or LimbKind.Antenna or LimbKind.Tail or LimbKind.Disc => (0.26f, 0.12f, new[] { 0.20f, 0.06f, 0f }),
            _ => throw new ArgumentOutOfRangeException(nameof(appendage), appendage.Kind, "expected a kind of limb"),
        };

        // Columns hardly fold, the joints of insects are hard, and flat feet fold away from their heels.
        creases = new JointCrease?[along.Length];
        for (int k = 1; k <= (flat ? 1 : 2) && legged && !insect && !rigidSole; k++)
        {
            int joint = joints.Left[k + 1];
            creases[k] = new JointCrease(appendage, k, skeleton.Joints[joint].Limit, skeleton.ModelRotations[joint]);
        }
    }

    /// <summary>Share of the limb's first joint in the body's vertices at the socket's border and one and two edges off it; the girdle of a leg adds its own.</summary>
    public float[] Border { get; }

    /// <summary>Adds what the limb pulls along of a vertex of the body.</summary>
    /// <param name="list">Receives the influences.</param>
    /// <param name="distance">Edges from the socket's border.</param>
    /// <param name="side">Joints on the side that pulls.</param>
    /// <param name="factor">Share of the pull to apply.</param>
    public void AddPull(ref InfluenceList list, int distance, int[] side, float factor)
    {
        float fraction = Border[distance] * factor;
        if (legged)
        {
            list.Add(side[1], fraction);
            list.Add(side[0], fraction * GirdlePull);
        }
        else
        {
            list.Add(side[0], fraction);
        }
    }

    /// <summary>All that the limb takes of a vertex of the body at a distance from the border.</summary>
    public float PullAt(int distance) => Border[distance] * (legged ? 1f + GirdlePull : 1f);

    /// <summary>Adds the influences of a vertex of the left limb.</summary>
    /// <param name="list">Receives the influences.</param>
    /// <param name="position">The vertex, model space, metres at scale 1.</param>
    /// <param name="address">Its address.</param>
    /// <param name="body">Who moves the body where the vertex grew from.</param>
    /// <param name="hold">Share of the limb's own joints: below 1 for fins so long that their ends follow the body instead.</param>
    public void Add(ref InfluenceList list, Vector3 position, in VertexAddress address, in SpineBlend body, float hold)
    {
        float x = Scalar.Clamp(address.Along, 0f, 1f);
        float chord = appendage.HeldByFlank ? 0.5f * (1f - (float)PortableMath.Cos(address.Around)) : 0f;
        float first = rootFraction * (1f - (HeldAtRoot * chord));
        float own = (first + ((1f - first) * Scalar.Smooth((x - ((appendage.IsCarried ? HeldAlong : 0f) * rootEnd * chord)) / (rootEnd + (HeldByFlank * chord))))) * hold;
        float rest = 1f - own;
        int root = legged ? 1 : 0;
        if (legged)
        {
            list.Add(joints[0], rest * GirdleFraction);
            rest *= 1f - GirdleFraction;
        }

        list.Add(body.First, rest * (1f - body.SecondWeight));
        list.Add(body.Second, rest * body.SecondWeight);

        // Joint k holds what came over joint k but not over joint k + 1.
        float over = own;
        for (int k = 1; k < along.Length - 1; k++)
        {
            float next = own * Passed(k, x, position, address);
            next = Math.Min(next, over);
            list.Add(joints[root + k - 1], over - next);
            over = next;
        }

        list.Add(joints[root + along.Length - 2], over);
    }

    /// <summary>Girdle's pull on the body's vertices in units of the first joint's: continues what the girdle holds of the limb at the border.</summary>
    private static float GirdlePull => (1f - 0.30f) * GirdleFraction / 0.30f;

    /// <summary>How much of the skin at x lies beyond joint k, 0..1.</summary>
    private float Passed(int k, float x, Vector3 position, in VertexAddress address)
    {
        bool toe = address.Region == SurfaceRegion.Toe;
        float passed = creases[k] is { } crease ? crease.Passed(position, x, stretch[k])
            : stretch[k] > 0f ? Scalar.Clamp((x - along[k] + stretch[k]) / (2f * stretch[k]), 0f, 1f)
            : x >= along[k] ? 1f : 0f;
        if (!legged)
        {
            return passed;
        }

        passed = toe ? 1f : Scalar.Smooth(passed);

        if (k == Ball)
        {
            passed = hasToes ? passed : 0f;
            return flat && !rigidSole ? Math.Max(passed, AheadOfBall(position)) : passed;
        }

        if (flat)
        {
            float ankle = Math.Max(appendage.Joints[2].Y, 1e-3f);
            passed = Math.Max(passed, 1f - Scalar.Smooth(((position.Y / ankle) - 0.45f) / 0.45f));
        }

        return passed;
    }

    /// <summary>How far a low vertex of a flat foot lies ahead of the ball.</summary>
    private float AheadOfBall(Vector3 position)
    {
        Vector3 ankle = appendage.Joints[2];
        Vector3 ball = appendage.Joints[3];
        if (position.Y >= 2.2f * Math.Max(ball.Y, 0.01f))
        {
            return 0f;
        }

        var foot = new Vector3(ball.X - ankle.X, 0f, ball.Z - ankle.Z);
        float length = (0.35f * Vec.Length(foot)) + 0.01f;
        float ahead = Vec.Dot(position - ball, Vec.Normalize(foot, Vector3.UnitZ));
        return Scalar.Smooth((ahead + length) / length);
    }
}
