using System;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>How much of the head's motion each vertex leaves to the jaw.</summary>
/// <remarks>
/// Below the mouth slit the skin is rigid on the jaw as far back as the lip corners and fades out over the rings to the hinge, from the slit downwards, exactly as the jaw was opened when the
/// surface was made. The bag between the lips goes over from one to the other by the number of steps from each.
/// </remarks>
internal static class MouthWeights
{
    /// <summary>Segment of the slit on the left flank.</summary>
    private const float Slit = 10f;

    /// <summary>Segments below the slit over which the skin behind the lip corners comes under the jaw.</summary>
    private const float Fade = 3f;

    /// <summary>Share of the lip corners themselves, which belong to both lips.</summary>
    private const float Corner = 0.5f;

    /// <summary>One share per vertex, 0..1; empty without a mouth.</summary>
    public static float[] Solve(Surface surface, SurfaceAdjacency adjacency, MouthSeam mouth)
    {
        if (!mouth.Opens)
        {
            return Array.Empty<float>();
        }

        float[] fractions = new float[surface.Positions.Length];
        int[] steps = new int[surface.Positions.Length];
        int[] queue = new int[surface.Positions.Length];
        int corner = mouth.CornerRing;
        int hinge = mouth.HingeRing;
        for (int v = 0; v < fractions.Length; v++)
        {
            VertexAddress address = surface.Addresses[v];
            if (address.Region == SurfaceRegion.Body && address.Ring <= hinge && address.Appendage < 0)
            {
                fractions[v] = OfSkin(address, corner, hinge);
            }
        }

        int last = mouth.LowerLip.Length - 1;
        for (int k = 1; k < last; k++)
        {
            fractions[mouth.UpperLip[k]] = 0f;
            fractions[mouth.LowerLip[k]] = 1f;
        }

        fractions[mouth.LowerLip[0]] = Corner;
        fractions[mouth.LowerLip[last]] = Corner;

        // The front of the jaw: what the lower lip reaches through the nose's cap.
        Flood(surface, adjacency, mouth.LowerLip, SurfaceRegion.Nose, steps, queue);
        for (int v = 0; v < fractions.Length; v++)
        {
            if (steps[v] > 0)
            {
                fractions[v] = 1f;
            }
        }

        // The bag: steps from the upper lip against steps from the lower.
        Array.Clear(steps, 0, steps.Length);
        int[] below = new int[steps.Length];
        Flood(surface, adjacency, mouth.UpperLip, SurfaceRegion.Mouth, steps, queue);
        Flood(surface, adjacency, mouth.LowerLip, SurfaceRegion.Mouth, below, queue);
        for (int v = 0; v < fractions.Length; v++)
        {
            if (steps[v] + below[v] > 0)
            {
                fractions[v] = (float)steps[v] / (steps[v] + below[v]);
            }
        }

        return fractions;
    }

    private static float OfSkin(in VertexAddress address, int corner, int hinge)
    {
        float edge = Math.Min(address.Segment, 32f - address.Segment) - Slit;
        if (edge <= 0f)
        {
            return 0f;
        }

        if (address.Ring <= corner)
        {
            return 1f;
        }

        return (float)(Scalar.Smooth((hinge - address.Ring) / (hinge - corner + 1.0)) * Scalar.Smooth(edge / Fade));
    }

    /// <summary>Steps along edges from the inner vertices of a lip, through vertices of one region only; 0 for what is not reached.</summary>
    private static void Flood(Surface surface, SurfaceAdjacency adjacency, int[] lip, SurfaceRegion region, int[] steps, int[] queue)
    {
        int end = 0;
        for (int k = 1; k < lip.Length - 1; k++)
        {
            queue[end++] = lip[k];
        }

        int seeds = end;
        for (int i = 0; i < end; i++)
        {
            int v = queue[i];
            foreach (int n in adjacency.Of(v))
            {
                if (surface.Addresses[n].Region == region && steps[n] == 0)
                {
                    steps[n] = i < seeds ? 1 : steps[v] + 1;
                    queue[end++] = n;
                }
            }
        }
    }
}
