using System;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Limbs;

/// <summary>Grows a thin blade, a wing or a fin, from a loop through chord lines from a leading to a trailing edge.</summary>
internal sealed class BladeSweep
{
    /// <summary>Size of the cap's texture chart, metres each way.</summary>
    private const float CapSize = 0.05f;

    private readonly Func<float, Vector3> lead;
    private readonly Func<float, Vector3> trail;

    /// <summary>Takes the two edges as functions of the share of the span, 0..1.</summary>
    public BladeSweep(Func<float, Vector3> lead, Func<float, Vector3> trail)
    {
        this.lead = lead;
        this.trail = trail;
    }

    /// <summary>Unit direction across the blade at a share of the span.</summary>
    public Func<float, Vector3> Normal { get; set; } = _ => Vector3.UnitY;

    /// <summary>A third point of each chord line, half way between its edges, for blades that bow; null for straight ones.</summary>
    public Func<float, Vector3>? Middle { get; set; }

    /// <summary>Half thickness at a share of the span (first) and of the chord from the leading edge (second).</summary>
    public Func<float, float, float> Thickness { get; set; } = (_, _) => 0.01f;

    /// <summary>Shares of the span at which chord lines are laid, ascending, the first 0.</summary>
    public float[] Sections { get; set; } = Array.Empty<float>();

    /// <summary>Share of the span over which the socket's outline turns into the blade.</summary>
    public float Blend { get; set; } = 0.12f;

    /// <summary>Exponent of the spacing of vertices over the chord: below 1 crowds them away from the leading edge.</summary>
    public float Crowding { get; set; } = 1f;

    /// <summary>What the vertices belong to.</summary>
    public VertexAddress Address { get; set; }

    /// <summary>Adds vertices and quads and returns the last loop.</summary>
    public int[] Grow(SurfaceBuilder surface, int[] loop)
    {
        int count = loop.Length;
        float[] chord = new float[count];
        float[] side = new float[count];
        float[] around = new float[count];
        var root = new Vector3[count];
        for (int k = 0; k < count; k++)
        {
            double a = PortableMath.Tau * k / count;
            double u = PortableMath.Pow((1 - PortableMath.Cos(a)) / 2, Crowding);
            chord[k] = (float)u;
            side[k] = k == 0 || 2 * k == count ? 0f : 2 * k < count ? 1f : -1f;
            double unfolded = PortableMath.Acos(Scalar.Clamp(1 - (2 * u), -1, 1));
            around[k] = (float)(side[k] < 0 ? PortableMath.Tau - unfolded : unfolded);
            root[k] = surface.Positions[loop[k]];
        }

        float span = Vec.Distance(lead(0f), lead(1f));
        float girth = 2f * Vec.Distance(lead(0.4f), trail(0.4f));
        int chart = surface.NewChart();
        Vector3 origin = (lead(0f) + trail(0f)) / 2f;
        int[][] loops = new int[Sections.Length][];
        loops[0] = loop;
        for (int q = 1; q < Sections.Length; q++)
        {
            float s = Sections[q];
            Vector3 a = lead(s);
            Vector3 b = trail(s);
            Vector3 normal = Normal(s);
            Vector3 bow = Middle is null ? Vector3.Zero : Middle(s) - ((a + b) / 2f);
            float blend = Blend > 0f ? Scalar.Smooth(s / Blend) : 1f;
            int[] current = new int[count];
            for (int k = 0; k < count; k++)
            {
                Vector3 p = Vec.Lerp(a, b, chord[k]) + (bow * (4f * chord[k] * (1f - chord[k]))) + (normal * (side[k] * Thickness(s, chord[k])));
                p = Vec.Lerp(root[k] + (((a + b) / 2f) - origin), p, blend);
                VertexAddress address = Address;
                VertexAddress rootAddress = surface.Addresses[loop[k]];
                address.Along = s;
                address.Around = around[k];
                address.Ring = rootAddress.Ring;
                address.Segment = rootAddress.Segment;
                current[k] = surface.Add(p, address);
            }

            loops[q] = current;
        }

        LimbSweep.AddRings(surface, loops, Array.ConvertAll(Sections, s => s * span), chart, girth);
        return loops[^1];
    }

    /// <summary>Closes the last loop with a level cap, as many rows and columns as the socket that it grew from.</summary>
    /// <param name="surface">Receives the cap.</param>
    /// <param name="end">The last loop, its corners where those of the socket are.</param>
    /// <param name="socket">Where the blade grows.</param>
    /// <param name="outward">Unit direction in which the cap faces.</param>
    public void Close(SurfaceBuilder surface, int[] end, SocketBlueprint socket, Vector3 outward)
    {
        VertexAddress address = Address;
        address.Along = 1f;
        int[] cap = CapGrid.Vertices(surface, end, socket.Rows, socket.Columns, outward, 0f, address);
        CapGrid.Fill(surface, cap, socket.Rows, socket.Columns, surface.NewChart(), new Vector2(CapSize, CapSize));
    }
}
