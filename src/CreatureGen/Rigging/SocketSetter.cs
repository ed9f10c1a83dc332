using System;
using System.Collections.Generic;
using System.Globalization;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>Finds the frames in which things are worn, held or ridden.</summary>
internal static class SocketSetter
{
    private const double TopSegment = 0;

    /// <summary>The crown is this far from the nose to where the head turns.</summary>
    private const double CrownPart = 0.7;

    /// <summary>Places between chest and hips that are tried for a saddle, and what it costs to be away from the middle: at either end as much as a slope of 30°.</summary>
    private const int SaddlePlaces = 9;
    private const double OffMiddle = 0.5;

    /// <summary>Rings to either side on which what is put on the back rests.</summary>
    private const double Stretch = 2;

    /// <summary>Below this share of its length nothing is left of the axis that gives a frame its roll.</summary>
    private const float MinAcross = 0.05f;

    /// <summary>All sockets: saddle, head, mouth, tip of the tail, hands from the front, then the points on the spine.</summary>
    public static CreatureSocket[] Find(Skeleton skeleton, RigInput input, SpineSegments spine, SpineLine line, SpineLayout layout, IReadOnlyList<LimbChain> limbs, IReadOnlyList<AttachmentPoint> points)
    {
        var sockets = new List<CreatureSocket>(points.Count + 8)
        {
            Saddle(skeleton, input.Skin, spine, line, layout),
            Crown(skeleton, input.Skin, spine, line),
            Mouth(skeleton, input, spine, line),
            TailTip(skeleton, spine, line),
        };
        foreach (LimbChain limb in limbs)
        {
            if (limb.Kind == LimbKind.Arm && limb.Side != Side.Right)
            {
                AddHands(sockets, skeleton, limb, limbs);
            }
        }

        foreach (AttachmentPoint point in points)
        {
            Side side = point.Normal.X > 0f ? Side.Left : point.Normal.X < 0f ? Side.Right : Side.Median;
            sockets.Add(OnSkin(skeleton, point.Name, SocketKind.Spine, side, point.Joint, point.Position, point.Normal, Headward(spine, line, point.Joint)));
        }

        return sockets.ToArray();
    }

    private static CreatureSocket Saddle(Skeleton skeleton, BodySkin skin, SpineSegments spine, SpineLine line, SpineLayout layout)
    {
        double chest = line.ArcAt(layout.ChestRing);
        double length = line.ArcAt(layout.PelvisRing) - chest;
        double best = double.NegativeInfinity;
        double arc = chest;
        for (int i = 1; i <= SaddlePlaces; i++)
        {
            double t = (double)i / (SaddlePlaces + 1);
            double away = (2 * t) - 1;
            double worth = Upward(skin, line.RingAt(chest + (t * length))).Y - (OffMiddle * away * away);
            if (worth > best)
            {
                best = worth;
                arc = chest + (t * length);
            }
        }

        return OnBack(skeleton, "Socket_Saddle", SocketKind.Saddle, spine.At(arc).Dominant, skin, line.RingAt(arc), Headward(spine, line, spine.At(arc).Dominant));
    }

    private static CreatureSocket Crown(Skeleton skeleton, BodySkin skin, SpineSegments spine, SpineLine line) =>
        OnBack(skeleton, "Socket_Head", SocketKind.Head, spine.Joints[0], skin, line.RingAt(CrownPart * spine.End(0)), Headward(spine, line, spine.Joints[0]));

    private static CreatureSocket Mouth(Skeleton skeleton, RigInput input, SpineSegments spine, SpineLine line)
    {
        int head = spine.Joints[0];
        Vector3 tip = line.HeadTip;
        Vector3 back = skeleton.ModelPositions[head];
        MouthSeam mouth = input.Mouth;
        if (mouth.Opens)
        {
            int middle = mouth.UpperLip.Length / 2;
            tip = Vec.Lerp(input.Surface.Positions[mouth.UpperLip[middle]], input.Surface.Positions[mouth.LowerLip[middle]], 0.5f);
            back = input.Skin.Shape.Centre(mouth.HingeRing);
        }

        tip.X = 0f;
        return Onward(skeleton, "Socket_Mouth", SocketKind.Mouth, Side.Median, head, tip, tip - back, Vector3.UnitX);
    }

    private static CreatureSocket TailTip(Skeleton skeleton, SpineSegments spine, SpineLine line)
    {
        int last = spine.Joints[spine.Joints.Length - 1];
        Vector3 tip = line.TailTip with { X = 0f };
        return Onward(skeleton, "Socket_TailTip", SocketKind.TailTip, Side.Median, last, tip, tip - skeleton.ModelPositions[last], -Vector3.UnitX);
    }

    private static void AddHands(List<CreatureSocket> sockets, Skeleton skeleton, LimbChain left, IReadOnlyList<LimbChain> limbs)
    {
        int ball = left.Joints[left.Joints.Count - 2];
        Vector3 knuckles = skeleton.ModelPositions[ball];
        Vector3 fingers = skeleton.ModelPositions[left.Joints[left.Joints.Count - 1]];
        Vector3 middle = Vec.Lerp(knuckles, fingers, 0.5f);
        string pair = left.Pair.ToString(CultureInfo.InvariantCulture);
        sockets.Add(Onward(skeleton, "Socket_Hand_L" + pair, SocketKind.Hand, Side.Left, ball, middle, fingers - knuckles, Vector3.UnitX));
        foreach (LimbChain right in limbs)
        {
            if (right.Kind == LimbKind.Arm && right.Side == Side.Right && right.Pair == left.Pair)
            {
                CreatureSocket hand = sockets[sockets.Count - 1];
                sockets.Add(hand with { Name = "Socket_Hand_R" + pair, Side = Side.Right, Joint = right.Joints[right.Joints.Count - 2], Position = Vec.Mirror(hand.Position), Rotation = Rotation.Mirror(hand.Rotation) });
            }
        }
    }

    /// <summary>On the midline of the back.</summary>
    private static CreatureSocket OnBack(Skeleton skeleton, string name, SocketKind kind, int joint, BodySkin skin, double ring, Vector3 headward) =>
        OnSkin(skeleton, name, kind, Side.Median, joint, skin.At(ring, TopSegment).Position with { X = 0f }, Upward(skin, ring), headward);

    /// <summary>Upright on a stretch of the back as long as what is put there, so that a wrinkle does not tilt it.</summary>
    private static Vector3 Upward(BodySkin skin, double ring)
    {
        Vector3 headward = skin.At(ring - Stretch, TopSegment).Position - skin.At(ring + Stretch, TopSegment).Position;
        return Vec.Normalize(Vec.Cross(headward with { X = 0f }, Vector3.UnitX), Vector3.UnitY);
    }

    /// <summary>Unit direction of a bone of the spine towards the head.</summary>
    private static Vector3 Headward(SpineSegments spine, SpineLine line, int joint)
    {
        int bone = spine.BoneOf(joint);
        return Vec.Normalize(line.At(line.RingAt(spine.Start(bone))) - line.At(line.RingAt(spine.End(bone))), Vector3.UnitZ);
    }

    /// <summary>A frame whose +Y is the skin's outward direction and whose +Z is towards the head as far as possible.</summary>
    private static CreatureSocket OnSkin(Skeleton skeleton, string name, SocketKind kind, Side side, int joint, Vector3 position, Vector3 normal, Vector3 headward)
    {
        Vector3 ahead = Vec.Reject(headward, normal);
        ahead = Vec.Length(ahead) > MinAcross ? Vec.Normalize(ahead) : Vec.Perpendicular(normal);
        return At(skeleton, name, kind, side, joint, position, Rotation.FromBasis(Vec.Cross(normal, ahead), normal, ahead));
    }

    /// <summary>A frame whose +Z goes on from a part of the body and whose +X is a given axis as far as possible.</summary>
    private static CreatureSocket Onward(Skeleton skeleton, string name, SocketKind kind, Side side, int joint, Vector3 position, Vector3 direction, Vector3 hinge)
    {
        Vector3 along = Vec.Normalize(direction, Vector3.UnitZ);
        Vector3 across = Vec.Reject(hinge, along);
        across = Vec.Normalize(Vec.Length(across) > MinAcross ? across : Vec.Perpendicular(along));
        return At(skeleton, name, kind, side, joint, position, Rotation.FromBasis(across, Vec.Cross(along, across), along));
    }

    private static CreatureSocket At(Skeleton skeleton, string name, SocketKind kind, Side side, int joint, Vector3 position, Quaternion rotation)
    {
        Quaternion toJoint = Rotation.Inverse(skeleton.ModelRotations[joint]);
        return new CreatureSocket(name, kind, side, joint, Rotation.Rotate(toJoint, position - skeleton.ModelPositions[joint]), Rotation.Normalize(Rotation.Multiply(toJoint, rotation)));
    }
}
