using System;
using System.Collections.Generic;

namespace CreatureGen.Gltf;

/// <summary>Lists of floats as accessors: equal lists are one.</summary>
internal sealed class FloatPool
{
    private const uint HashStart = 2166136261;
    private const uint HashFactor = 16777619;

    private readonly BufferPlan plan;
    private readonly List<(Accessor Accessor, float[] Numbers)> kept = new();
    private readonly Dictionary<(ElementShape Shape, uint Hash), List<int>> known = new();

    public FloatPool(BufferPlan plan) => this.plan = plan;

    /// <summary>The accessor of a list.</summary>
    /// <param name="shape">Of its elements.</param>
    /// <param name="numbers">All numbers, element by element.</param>
    /// <param name="width">Numbers of an element.</param>
    public Accessor Add(ElementShape shape, float[] numbers, int width)
    {
        uint hash = HashStart;
        foreach (float number in numbers)
        {
            hash = unchecked((hash ^ (uint)BitConverter.SingleToInt32Bits(number)) * HashFactor);
        }

        if (!known.TryGetValue((shape, hash), out List<int>? alike))
        {
            alike = new List<int>();
            known.Add((shape, hash), alike);
        }

        foreach (int index in alike)
        {
            if (numbers.AsSpan().SequenceEqual(kept[index].Numbers))
            {
                return kept[index].Accessor;
            }
        }

        Accessor accessor = plan.Add(shape, ComponentFormat.Float, numbers.Length / width, BufferTarget.None);
        alike.Add(kept.Count);
        kept.Add((accessor, numbers));
        return accessor;
    }

    /// <summary>Writes all lists into the binary chunk.</summary>
    public void Write(Span<byte> binary)
    {
        foreach ((Accessor accessor, float[] numbers) in kept)
        {
            Span<byte> bytes = BufferPlan.Bytes(accessor, binary);
            for (int i = 0; i < numbers.Length; i++)
            {
                LittleEndian.Write(bytes, 4 * i, numbers[i]);
            }
        }
    }
}
