using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>
/// The capsule around the trunk that stands for the whole creature, in the space of the root joint (which is the model's at rest): it lies along the trunk, at the body's centre.
/// The height of that centre is how high the creature stands.
/// </summary>
internal static class BodyCapsule
{
    /// <summary>Rings beyond chest and pelvis that still count as trunk.</summary>
    private const double Margin = 3;

    /// <summary>Fits the capsule.</summary>
    /// <param name="surface">The skin.</param>
    /// <param name="layout">Says where the trunk begins and ends.</param>
    /// <param name="front">Front end of the trunk's line, model space.</param>
    /// <param name="rear">Rear end of it.</param>
    public static CapsuleCollider Fit(Surface surface, SpineLayout layout, Vector3 front, Vector3 rear)
    {
        double first = layout.ChestRing - Margin;
        double last = layout.PelvisRing + Margin;
        var points = new List<Vector3>(1024);
        for (int v = 0; v < surface.Positions.Length; v++)
        {
            VertexAddress address = surface.Addresses[v];
            if (address.Region == SurfaceRegion.Body && address.Ring >= first && address.Ring <= last)
            {
                points.Add(surface.Positions[v]);
            }
        }

        Vector3 direction = Vec.Normalize(front - rear, Vector3.UnitZ);
        CapsuleFit fit = CapsuleFit.Around(points.ToArray(), rear, direction, median: true, new float[2 * points.Count]);
        return new CapsuleCollider(0, fit.Start, fit.End, fit.Radius);
    }
}
