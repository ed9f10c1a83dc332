using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Subjects;

/// <summary>How thick the skin of bones is.</summary>
internal static class BoneSkin
{
    /// <summary>Cosine of the slope from which on a bone says nothing of what is below it when it lies.</summary>
    private const float MinLevel = 0.3f;

    /// <summary>How far the skin of each bone is below its line when that lies level, as far as it is above the ground at rest, and beyond its tip below that, metres: at least so high it has to be above the ground.</summary>
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
                Vector3 down = (along * along.Y) - Vector3.UnitY;
                float depth = Vec.Dot(mesh.Positions[v] - place, down);

                // A steep bone has more skin below it as it comes to lie, but is not bent up where it is at rest.
                depth = Math.Max(depth, Math.Min(depth / Math.Max(Vec.Length(down), MinLevel), tip.Y));
                depth = Vec.Dot(mesh.Positions[v] - tip, along) > 0f ? Math.Max(depth, tip.Y - mesh.Positions[v].Y) : depth;
                below[bone] = Math.Max(below[bone], depth);
            }
        }

        return below;
    }
}
