using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Subjects;

/// <summary>How thick the skin of bones is.</summary>
internal static class BoneSkin
{
    /// <summary>How far the skin of each bone is below its line, and beyond its tip below that, at rest, metres: at least so high it has to be above the ground.</summary>
    /// <param name="subject">Whose.</param>
    /// <param name="joints">Of the bones.</param>
    /// <param name="directions">Of the bones, each in its joint's own space, unit.</param>
    /// <param name="lengths">Of the bones, metres.</param>
    public static float[] Below(MotionSubject subject, ReadOnlySpan<int> joints, ReadOnlySpan<Vector3> directions, ReadOnlySpan<float> lengths)
    {
        Skeleton skeleton = subject.Skeleton;
        CreatureMesh mesh = subject.Mesh;
        float[] below = new float[joints.Length];
        for (int v = 0; v < mesh.Positions.Length; v++)
        {
            int bone = joints.IndexOf(mesh.Weights[v].Joint0);
            if (bone >= 0)
            {
                Vector3 place = skeleton.ModelPositions[joints[bone]];
                Vector3 along = Rotation.Rotate(skeleton.ModelRotations[joints[bone]], directions[bone]);
                Vector3 tip = place + (along * lengths[bone]);
                float depth = Vec.Dot(mesh.Positions[v] - place, (along * along.Y) - Vector3.UnitY);
                depth = Vec.Dot(mesh.Positions[v] - tip, along) > 0f ? Math.Max(depth, tip.Y - mesh.Positions[v].Y) : depth;
                below[bone] = Math.Max(below[bone], depth);
            }
        }

        return below;
    }
}
