using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Ragdolls;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>How hard a joint is to throw aside by what hangs on it.</summary>
internal static class HangingInertia
{
    /// <summary>For each joint the moment of inertia of all that hangs on it about it, kg m² of the model; 0 where it does not give: it carries what stands, or does not turn.</summary>
    public static float[] Of(Skeleton skeleton, RagdollRig rig, float mass, ReadOnlySpan<int> feet)
    {
        var inertias = new float[skeleton.Count];
        ReadOnlySpan<RagdollPart> parts = rig.Parts;
        for (int i = 1; i < parts.Length; i++)
        {
            Vector3 centre = skeleton.ModelPositions[parts[i].Joint] + Rotation.Rotate(skeleton.ModelRotations[parts[i].Joint], parts[i].Centre);
            float reach = skeleton.Joints[parts[i].Joint].Length;
            for (int p = i; p > 0; p = parts[p].Parent)
            {
                float arm = Vec.Distance(centre, skeleton.ModelPositions[parts[p].Joint]);
                inertias[parts[p].Joint] += mass / parts[i].InverseMass * ((arm * arm) + (0.1f * reach * reach));
            }
        }

        foreach (int foot in feet)
        {
            for (int j = foot; j >= 0; j = skeleton.Parents[j])
            {
                inertias[j] = 0f;
            }
        }

        return inertias;
    }
}
