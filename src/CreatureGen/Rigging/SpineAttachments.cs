using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>Places on the skin half way along each bone of the spine: top, left and right, with the body's width there (the hip width of the bone).</summary>
internal static class SpineAttachments
{
    private const double TopSegment = 0;
    private const double LeftSegment = 8;

    /// <summary>Three points per bone, nose to tail, each top, left, right. Model space, in the units of the skin.</summary>
    public static AttachmentPoint[] Find(Skeleton skeleton, SpineSegments spine, SpineLine line, BodySkin skin)
    {
        var points = new List<AttachmentPoint>(3 * spine.Joints.Length);
        for (int bone = 0; bone < spine.Joints.Length; bone++)
        {
            int joint = spine.Joints[bone];
            string name = skeleton.Joints[joint].Name;
            double ring = line.RingAt((spine.Start(bone) + spine.End(bone)) / 2);
            SurfacePoint top = skin.At(ring, TopSegment);
            SurfacePoint left = skin.At(ring, LeftSegment);
            float width = 2f * left.Position.X;
            Vector3 upward = Vec.Normalize(new Vector3(0f, top.Normal.Y, top.Normal.Z), Vector3.UnitY);
            points.Add(new AttachmentPoint(name + "_Top", joint, new Vector3(0f, top.Position.Y, top.Position.Z), upward, width));
            points.Add(new AttachmentPoint(name + "_Left", joint, left.Position, left.Normal, width));
            points.Add(new AttachmentPoint(name + "_Right", joint, Vec.Mirror(left.Position), Vec.Mirror(left.Normal), width));
        }

        return points.ToArray();
    }
}
