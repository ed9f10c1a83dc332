using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;

namespace CreatureGen.Rigging;

/// <summary>The joints of one appendage.</summary>
internal readonly struct AppendageJoints
{
    public AppendageJoints(int[] left, int[] right)
    {
        Left = left;
        Right = right;
    }

    /// <summary>Root to end, the end joint included; of an appendage on the midline its only joints.</summary>
    public int[] Left { get; }

    /// <summary>The same on the right; empty on the midline.</summary>
    public int[] Right { get; }
}

/// <summary>What a game uses of a rig, at the creature's own size.</summary>
/// <param name="Skeleton">The joints.</param>
/// <param name="Limbs">Limbs as chains of joints.</param>
/// <param name="AttachmentPoints">Top, left and right of every spine bone.</param>
/// <param name="Sockets">Frames in which things are worn, held or ridden.</param>
/// <param name="Body">The capsule that stands for the whole creature, in the space of the root joint.</param>
/// <param name="StandingHeight">Height of the body's centre above the ground, metres.</param>
internal sealed record FinishedRig(Skeleton Skeleton, IReadOnlyList<LimbChain> Limbs, IReadOnlyList<AttachmentPoint> AttachmentPoints, IReadOnlyList<CreatureSocket> Sockets, CapsuleCollider Body, float StandingHeight);

/// <summary>A skeleton fitted to a surface at scale 1, with what the weights need to know of it.</summary>
internal sealed class Rig
{
    public Rig(Skeleton skeleton, SpineSegments spine, SpineLine line, IReadOnlyList<AppendageJoints> appendages, IReadOnlyList<LimbChain> limbs, IReadOnlyList<AttachmentPoint> attachmentPoints, IReadOnlyList<CreatureSocket> sockets, CapsuleCollider body, int head, int jaw)
    {
        Skeleton = skeleton;
        Spine = spine;
        Line = line;
        Appendages = appendages;
        Limbs = limbs;
        AttachmentPoints = attachmentPoints;
        Sockets = sockets;
        Body = body;
        Head = head;
        Jaw = jaw;
    }

    public Skeleton Skeleton { get; }

    /// <summary>Who moves the skin of the body where.</summary>
    public SpineSegments Spine { get; }

    /// <summary>The line of the spine.</summary>
    public SpineLine Line { get; }

    /// <summary>One entry per appendage.</summary>
    public IReadOnlyList<AppendageJoints> Appendages { get; }

    public IReadOnlyList<LimbChain> Limbs { get; }

    public IReadOnlyList<AttachmentPoint> AttachmentPoints { get; }

    public IReadOnlyList<CreatureSocket> Sockets { get; }

    public CapsuleCollider Body { get; }

    /// <summary>The head's joint.</summary>
    public int Head { get; }

    /// <summary>The jaw's joint, −1 without a mouth.</summary>
    public int Jaw { get; }

    /// <summary>The finished rig of a creature that is larger by a factor.</summary>
    public FinishedRig Scaled(float factor)
    {
        var limbs = new LimbChain[Limbs.Count];
        for (int i = 0; i < limbs.Length; i++)
        {
            LimbChain limb = Limbs[i];
            float[] lengths = new float[limb.RestLengths.Count];
            for (int k = 0; k < lengths.Length; k++)
            {
                lengths[k] = limb.RestLengths[k] * factor;
            }

            limbs[i] = limb with { RestLengths = lengths, Contact = limb.Contact * factor };
        }

        var points = new AttachmentPoint[AttachmentPoints.Count];
        for (int i = 0; i < points.Length; i++)
        {
            AttachmentPoint point = AttachmentPoints[i];
            points[i] = point with { Position = point.Position * factor, Width = point.Width * factor };
        }

        var sockets = new CreatureSocket[Sockets.Count];
        for (int i = 0; i < sockets.Length; i++)
        {
            sockets[i] = Sockets[i] with { Position = Sockets[i].Position * factor };
        }

        Skeleton skeleton = SkeletonBuilder.Scale(Skeleton, factor);
        var body = new CapsuleCollider(Body.Joint, Body.Start * factor, Body.End * factor, Body.Radius * factor);
        return new FinishedRig(skeleton, limbs, points, sockets, body, HeightOf(skeleton));
    }

    private static float HeightOf(Skeleton skeleton) => skeleton.FirstOf(JointRole.Body) is >= 0 and int body ? skeleton.ModelPositions[body].Y : 0f;
}
