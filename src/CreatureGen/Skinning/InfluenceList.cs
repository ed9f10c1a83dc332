using System;
using System.Numerics;

namespace CreatureGen.Skinning;

/// <summary>The influences of one vertex while they are collected, over buffers that the caller owns.</summary>
internal ref struct InfluenceList
{
    /// <summary>Most influences that may be collected.</summary>
    public const int Capacity = 16;

    /// <summary>
    /// Weights are multiples of 2⁻²⁰: then every sum of weights is exact in single precision, in any order, and four of them make exactly one.
    /// </summary>
    private const float Grain = 1f / (1 << 20);

    /// <summary>Share of the whole below which an influence is dropped: it could not be seen, but would cost a joint.</summary>
    private const float Min = 0.002f;

    private readonly Span<int> joints;
    private readonly Span<float> weights;
    private int count;

    /// <summary>Takes two spans of at least <see cref="Capacity"/> entries.</summary>
    public InfluenceList(Span<int> joints, Span<float> weights)
    {
        this.joints = joints;
        this.weights = weights;
        count = 0;
    }

    /// <summary>Sum of all weights so far.</summary>
    public readonly float Total
    {
        get
        {
            float total = 0f;
            for (int i = 0; i < count; i++)
            {
                total += weights[i];
            }

            return total;
        }
    }

    /// <summary>Forgets everything.</summary>
    public void Clear() => count = 0;

    /// <summary>Multiplies all weights so far.</summary>
    public readonly void Scale(float factor)
    {
        for (int i = 0; i < count; i++)
        {
            weights[i] *= factor;
        }
    }

    /// <summary>Adds to the weight of a joint.</summary>
    public void Add(int joint, float weight)
    {
        if (weight <= 0f)
        {
            return;
        }

        for (int i = 0; i < count; i++)
        {
            if (joints[i] == joint)
            {
                weights[i] += weight;
                return;
            }
        }

        if (count == Capacity)
        {
            throw new InvalidOperationException(FormattableString.Invariant($"a vertex is moved by more than {Capacity} joints; expected few limbs to meet at one place"));
        }

        joints[count] = joint;
        weights[count++] = weight;
    }

    /// <summary>The four largest, in descending order (ties: the smaller joint first), made to sum to exactly one.</summary>
    /// <exception cref="InvalidOperationException">There is no positive weight, or one is not a number.</exception>
    public readonly SkinWeights ToWeights()
    {
        Sort();
        int used = Math.Min(count, 4);
        float sum = 0f;
        for (int i = 0; i < used; i++)
        {
            sum += weights[i];
        }

        if (!(sum > 0f) || float.IsInfinity(sum))
        {
            throw new InvalidOperationException("the weights of a vertex have no finite positive sum; expected at least one joint to move it");
        }

        // Rounded down, so that what is left over makes the largest larger still and the order stays.
        Span<float> fractions = stackalloc float[4];
        float rest = 0f;
        for (int i = 1; i < used; i++)
        {
            float fraction = weights[i] / sum;
            fractions[i] = fraction < Min ? 0f : (float)Math.Floor(fraction / Grain) * Grain;
            rest += fractions[i];
        }

        fractions[0] = 1f - rest;
        return new SkinWeights(
            joints[0],
            fractions[1] > 0f ? joints[1] : 0,
            fractions[2] > 0f ? joints[2] : 0,
            fractions[3] > 0f ? joints[3] : 0,
            new Vector4(fractions[0], fractions[1], fractions[2], fractions[3]));
    }

    private readonly void Sort()
    {
        for (int i = 1; i < count; i++)
        {
            int joint = joints[i];
            float weight = weights[i];
            int k = i - 1;
            while (k >= 0 && (weights[k] < weight || (weights[k] == weight && joints[k] > joint)))
            {
                joints[k + 1] = joints[k];
                weights[k + 1] = weights[k];
                k--;
            }

            joints[k + 1] = joint;
            weights[k + 1] = weight;
        }
    }
}
