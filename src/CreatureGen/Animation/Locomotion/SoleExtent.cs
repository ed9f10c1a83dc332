using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Animation.Locomotion;

/// <summary>How far a foot's sole reaches on the ground, ahead of the ball and behind it, metres.</summary>
internal readonly struct SoleExtent
{
    /// <summary>Height below which skin is sole, part of the ball's height.</summary>
    private const float SoleShare = 0.55f;

    private SoleExtent(float toe, float heel)
    {
        Toe = toe;
        Heel = heel;
    }

    public float Toe { get; }

    public float Heel { get; }

    /// <summary>Measures the soles of all legs on the skin.</summary>
    public static SoleExtent[] Measure(Creature creature, LimbChain[] legs)
    {
        Skeleton skeleton = creature.Skeleton;
        int[] legOf = new int[skeleton.Count];
        Array.Fill(legOf, -1);
        var ahead = new Vector3[legs.Length];
        for (int i = 0; i < legs.Length; i++)
        {
            Vector3 toes = skeleton.ModelPositions[legs[i].Joints[5]] - skeleton.ModelPositions[legs[i].Joints[4]];
            toes.Y = 0f;
            ahead[i] = Vec.Normalize(toes, Vector3.UnitZ);
            for (int k = 3; k <= 5; k++)
            {
                legOf[legs[i].Joints[k]] = i;
            }
        }

        var toe = new float[legs.Length];
        var heel = new float[legs.Length];
        ReadOnlySpan<SkinWeights> weights = creature.Mesh.Weights;
        ReadOnlySpan<Vector3> positions = creature.Mesh.Positions;
        for (int v = 0; v < positions.Length; v++)
        {
            int leg = legOf[weights[v].Joint0];
            if (leg < 0)
            {
                continue;
            }

            Vector3 ball = skeleton.ModelPositions[legs[leg].Joints[4]];
            if (positions[v].Y > SoleShare * ball.Y)
            {
                continue;
            }

            float along = Vec.Dot(positions[v] - ball, ahead[leg]);
            toe[leg] = Math.Max(toe[leg], along);
            heel[leg] = Math.Max(heel[leg], -along);
        }

        var extents = new SoleExtent[legs.Length];
        for (int i = 0; i < legs.Length; i++)
        {
            extents[i] = new SoleExtent(toe[i], heel[i]);
        }

        return extents;
    }
}
