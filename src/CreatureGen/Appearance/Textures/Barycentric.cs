using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Appearance.Textures;

/// <summary>Weights of the three corners of a triangle; they sum to one.</summary>
internal readonly struct Barycentric
{
    private readonly float a;
    private readonly float b;
    private readonly float c;

    public Barycentric(float a, float b, float c)
    {
        this.a = a;
        this.b = b;
        this.c = c;
    }

    /// <summary>The mean of three numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float Mix(float atA, float atB, float atC) => (atA * a) + (atB * b) + (atC * c);

    /// <summary>The mean of three vectors.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3 Mix(Vector3 atA, Vector3 atB, Vector3 atC) => (atA * a) + (atB * b) + (atC * c);

    /// <summary>The mean of three fours of numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector4 Mix(in Vector4 atA, in Vector4 atB, in Vector4 atC) => (atA * a) + (atB * b) + (atC * c);
}
