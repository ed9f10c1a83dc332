using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>
/// Area, volume, centroid and inertia of the body that a closed surface encloses, filled evenly with unit density.
/// </summary>
/// <remarks>
/// Each triangle makes a signed tetrahedron with the middle of the surface's box, and the tetrahedra add up to the body (S. Lien and J. T. Kajiya 1984,
/// "A symbolic method for calculating the integral properties of arbitrary nonconvex polyhedra"); their inertia is that of F. Tonon 2004, "Explicit exact formulas
/// for the 3-D tetrahedron inertia tensor in terms of its vertex coordinates". Sums run in doubles in the order of the triangles.
/// Parts of the body that the surface encloses twice count twice. A surface that is turned inside out has a negative volume and inertia.
/// </remarks>
internal readonly struct SolidProperties
{
    private SolidProperties(double area, double volume, double x, double y, double z, double xx, double yy, double zz, double xy, double yz, double zx)
    {
        Area = area;
        Volume = volume;
        CentroidX = x;
        CentroidY = y;
        CentroidZ = z;
        InertiaXX = xx;
        InertiaYY = yy;
        InertiaZZ = zz;
        InertiaXY = xy;
        InertiaYZ = yz;
        InertiaZX = zx;
    }

    /// <summary>Area of the surface, square metres.</summary>
    public double Area { get; }

    /// <summary>Volume, cubic metres.</summary>
    public double Volume { get; }

    /// <summary>X of the centroid, metres.</summary>
    public double CentroidX { get; }

    /// <summary>Y of the centroid, metres.</summary>
    public double CentroidY { get; }

    /// <summary>Z of the centroid, metres.</summary>
    public double CentroidZ { get; }

    /// <summary>The centroid in the space of the surface, metres.</summary>
    public Vector3 Centroid => new((float)CentroidX, (float)CentroidY, (float)CentroidZ);

    /// <summary>∫ y² + z² about the centroid, m⁵; times the density in kg/m³ it is the moment of inertia in kg·m².</summary>
    public double InertiaXX { get; }

    /// <summary>∫ z² + x² about the centroid, m⁵.</summary>
    public double InertiaYY { get; }

    /// <summary>∫ x² + y² about the centroid, m⁵.</summary>
    public double InertiaZZ { get; }

    /// <summary>−∫ xy about the centroid, m⁵: the entry xy of the inertia tensor, with its minus sign.</summary>
    public double InertiaXY { get; }

    /// <summary>−∫ yz about the centroid, m⁵.</summary>
    public double InertiaYZ { get; }

    /// <summary>−∫ zx about the centroid, m⁵.</summary>
    public double InertiaZX { get; }

    /// <summary>Measures the body that a surface encloses. Whether the surface is closed is not examined; see <see cref="SurfaceTopology.IsClosed"/>.</summary>
    /// <param name="positions">One per vertex, metres.</param>
    /// <param name="triangles">Vertex indices, three per triangle, counter-clockwise seen from outside.</param>
    /// <exception cref="ArgumentException">The indices are not three per triangle, one is out of range, a position is not finite, or the surface encloses no volume.</exception>
    public static SolidProperties Of(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles)
    {
        TriangleList.Count(positions.Length, triangles);
        TriangleList.RequireFinite(positions);
        PointBounds box = PointBounds.Of(positions);
        double ox = 0.5 * ((double)box.Min.X + box.Max.X);
        double oy = 0.5 * ((double)box.Min.Y + box.Max.Y);
        double oz = 0.5 * ((double)box.Min.Z + box.Max.Z);
        double area = 0, volume = 0, sx = 0, sy = 0, sz = 0;
        double sxx = 0, syy = 0, szz = 0, sxy = 0, syz = 0, szx = 0;
        for (int t = 0; t + 2 < triangles.Length; t += 3)
        {
            Vector3 a = positions[triangles[t]], b = positions[triangles[t + 1]], c = positions[triangles[t + 2]];
            double ax = a.X - ox, ay = a.Y - oy, az = a.Z - oz;
            double bx = b.X - ox, by = b.Y - oy, bz = b.Z - oz;
            double cx = c.X - ox, cy = c.Y - oy, cz = c.Z - oz;
            double ux = bx - ax, uy = by - ay, uz = bz - az;
            double vx = cx - ax, vy = cy - ay, vz = cz - az;
            double nx = (uy * vz) - (uz * vy), ny = (uz * vx) - (ux * vz), nz = (ux * vy) - (uy * vx);
            area += Math.Sqrt((nx * nx) + (ny * ny) + (nz * nz));
            double six = (ax * nx) + (ay * ny) + (az * nz);
            double x = ax + bx + cx, y = ay + by + cy, z = az + bz + cz;
            volume += six;
            sx += six * x;
            sy += six * y;
            sz += six * z;
            sxx += six * ((ax * ax) + (bx * bx) + (cx * cx) + (x * x));
            syy += six * ((ay * ay) + (by * by) + (cy * cy) + (y * y));
            szz += six * ((az * az) + (bz * bz) + (cz * cz) + (z * z));
            sxy += six * ((ax * ay) + (bx * by) + (cx * cy) + (x * y));
            syz += six * ((ay * az) + (by * bz) + (cy * cz) + (y * z));
            szx += six * ((az * ax) + (bz * bx) + (cz * cx) + (z * x));
        }

        area /= 2;
        volume /= 6;
        if (!(Math.Abs(volume) > Tolerance.VolumePerAreaAndDiagonal * area * box.Diagonal))
        {
            throw new ArgumentException(FormattableString.Invariant($"the surface encloses a volume of {volume} with an area of {area}; expected a closed surface around a body"), nameof(triangles));
        }

        double mx = sx / 24 / volume, my = sy / 24 / volume, mz = sz / 24 / volume;
        double xx = (sxx / 120) - (volume * mx * mx), yy = (syy / 120) - (volume * my * my), zz = (szz / 120) - (volume * mz * mz);
        return new SolidProperties(
            area,
            volume,
            ox + mx,
            oy + my,
            oz + mz,
            yy + zz,
            zz + xx,
            xx + yy,
            (volume * mx * my) - (sxy / 120),
            (volume * my * mz) - (syz / 120),
            (volume * mz * mx) - (szx / 120));
    }
}
