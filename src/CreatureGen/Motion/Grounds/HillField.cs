using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Motion;

/// <summary>Smooth seeded hills, so long and high as the legs of who goes over them: the sum of three waves of 1.9, 2.4 and 3 leg lengths in different directions, each 0.048 leg lengths high.</summary>
/// <remarks>Heights are a <see cref="HeightFieldGround"/> of cells of 0.08 leg lengths. They are a function of place and seed alone, not of the extent of the field.</remarks>
public sealed class HillField
{
    private const float CellFraction = 0.08f;
    private const float HeightFraction = 0.048f;
    private const float MaxRows = 60000f;

    // Wave numbers across and along, per leg length.
    private static readonly Vector2[] waves = { new(2.1f, 0f), new(0f, 3.3f), new(1.3f, 2.2f) };

    private readonly float length;
    private readonly double[] phases = new double[3];
    private readonly double[] across = new double[3];
    private readonly double[] along = new double[3];

    /// <summary>Hills that go on for ever without repeating.</summary>
    /// <param name="seed">Decides where the hills are.</param>
    /// <param name="legLength">Metres.</param>
    /// <exception cref="ArgumentException">The length is out of 1e-4..1e4.</exception>
    public HillField(Seed seed, float legLength)
    {
        Finite.RequireWithin(legLength, 1e-4f, 1e4f, nameof(legLength));
        length = legLength;
        RandomStream random = seed.Child("hills").Stream();
        for (int i = 0; i < waves.Length; i++)
        {
            phases[i] = random.Uniform(0, PortableMath.Tau);
            across[i] = waves[i].X / legLength;
            along[i] = waves[i].Y / legLength;
        }
    }

    /// <summary>Hills that are the same again after a way along +Z: each wave is drawn out or shortened until a whole number of it fits.</summary>
    /// <param name="seed">Decides where the hills are.</param>
    /// <param name="legLength">Metres.</param>
    /// <param name="period">Metres along +Z after which they repeat.</param>
    /// <exception cref="ArgumentException">A length is out of 1e-4..1e4.</exception>
    public HillField(Seed seed, float legLength, float period)
        : this(seed, legLength)
    {
        Finite.RequireWithin(period, 1e-4f, 1e4f, nameof(period));
        for (int i = 0; i < along.Length; i++)
        {
            along[i] = Math.Round(along[i] * period / PortableMath.Tau) * PortableMath.Tau / period;
        }
    }

    /// <summary>The part of the hills around the Z axis, as ground.</summary>
    /// <param name="halfWidth">Metres to the left and right of it.</param>
    /// <param name="from">Least z, metres.</param>
    /// <param name="to">Greatest z, metres.</param>
    /// <exception cref="ArgumentException">A number is not finite, there is no extent, or it is more than 60,000 cells long.</exception>
    public HeightFieldGround Around(float halfWidth, float from, float to)
    {
        float cell = CellFraction * length;
        Finite.RequireWithin(halfWidth, cell, MaxRows * cell, nameof(halfWidth));
        Finite.RequireWithin(to - from, cell, MaxRows * cell, nameof(to));
        int columns = 2 + (int)Math.Ceiling(2f * halfWidth / cell);
        int rows = 2 + (int)Math.Ceiling((to - from) / cell);
        var corner = new Vector3(-halfWidth, 0f, from);
        var heights = new float[rows * columns];
        for (int wave = 0; wave < phases.Length; wave++)
        {
            // sin(a + b) = sin a cos b + cos a sin b: one sine for each row and column, not for each cell.
            var sines = new double[columns];
            var cosines = new double[columns];
            for (int i = 0; i < columns; i++)
            {
                PortableMath.SinCos((across[wave] * (corner.X + (i * (double)cell))) + phases[wave], out sines[i], out cosines[i]);
            }

            for (int k = 0; k < rows; k++)
            {
                PortableMath.SinCos(along[wave] * (corner.Z + (k * (double)cell)), out double sine, out double cosine);
                for (int i = 0; i < columns; i++)
                {
                    heights[(k * columns) + i] += (float)(HeightFraction * length * ((sines[i] * cosine) + (cosines[i] * sine)));
                }
            }
        }

        return new HeightFieldGround(heights, columns, cell, corner);
    }
}
