using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Acts.Bodies;

/// <summary>A point of the skin, and the joints that move it, each with its share.</summary>
internal sealed class SkinPoint
{
    private readonly (int Joint, float Weight, Vector3 Point)[] shares;

    /// <summary>A point of a skin at rest.</summary>
    /// <param name="skeleton">At rest.</param>
    /// <param name="place">Model space.</param>
    /// <param name="weights">Of the joints that move it.</param>
    public SkinPoint(Skeleton skeleton, Vector3 place, in SkinWeights weights)
    {
        int count = weights.Weights.Y <= 0f ? 1 : weights.Weights.Z <= 0f ? 2 : weights.Weights.W <= 0f ? 3 : 4;
        shares = new (int, float, Vector3)[count];
        for (int i = 0; i < count; i++)
        {
            (int joint, float weight) = i switch
            {
                0 => (weights.Joint0, weights.Weights.X),
                1 => (weights.Joint1, weights.Weights.Y),
                2 => (weights.Joint2, weights.Weights.Z),
                _ => (weights.Joint3, weights.Weights.W),
            };
            shares[i] = (joint, weight, Rotation.Rotate(Rotation.Inverse(skeleton.ModelRotations[joint]), place - skeleton.ModelPositions[joint]));
        }
    }

    /// <summary>The joint that moves it most.</summary>
    public int Joint => shares[0].Joint;

    /// <summary>Where it is in a pose, model space.</summary>
    public Vector3 PlaceIn(in Pose model)
    {
        Vector3 sum = Vector3.Zero;
        foreach ((int joint, float weight, Vector3 point) in shares)
        {
            sum += (model.Positions[joint] + Rotation.Rotate(model.Rotations[joint], point)) * weight;
        }

        return sum;
    }
}
