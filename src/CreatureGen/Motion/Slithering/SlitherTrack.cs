using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Slithering;

/// <summary>
/// The way that a head has taken over the ground: points at even steps of arc length in a ring buffer, and between them a smooth curve through them.
/// </summary>
/// <remarks>Places are counted in metres of arc length since the start. The curve is a Catmull–Rom spline; two points ahead of the head are foreseen, so that it reaches up to the head.</remarks>
internal sealed class SlitherTrack
{
    private const int PointsPerWave = 48;
    private const int Ahead = 2;
    private const double Spare = 1.35;

    private readonly double[] x;
    private readonly double[] y;
    private readonly double[] z;
    private readonly double[] travel;
    private readonly Vector3[] normals;
    private long newest;

    public SlitherTrack(double body, double wavelength)
    {
        Wavelength = wavelength;
        Step = wavelength / PointsPerWave;
        int capacity = (int)(Spare * body / Step) + 8;
        x = new double[capacity];
        y = new double[capacity];
        z = new double[capacity];
        travel = new double[capacity];
        normals = new Vector3[capacity];
    }

    /// <summary>Arc length from one bend to the next to the same side.</summary>
    public double Wavelength { get; }

    /// <summary>Arc length between points.</summary>
    public double Step { get; }

    /// <summary>Arc length of the head.</summary>
    public double Head { get; private set; }

    /// <summary>Where the head is.</summary>
    public TrackPoint HeadPoint { get; private set; }

    /// <summary>Takes over the way of another of the same creature.</summary>
    public void CopyFrom(SlitherTrack other)
    {
        other.x.CopyTo(x, 0);
        other.y.CopyTo(y, 0);
        other.z.CopyTo(z, 0);
        other.travel.CopyTo(travel, 0);
        other.normals.CopyTo(normals, 0);
        newest = other.newest;
        Head = other.Head;
        HeadPoint = other.HeadPoint;
    }

    /// <summary>Fills the track with the way on which a head would have come to where it is, on the ground near a height.</summary>
    public void Lay(double headX, double near, double headZ, in TrackSteering steer, in CrawlFloor floor)
    {
        Head = 0;
        newest = Ahead;
        double px = headX;
        double pz = headZ;
        for (long point = 0; point < newest; point++)
        {
            Stride(point, steer, out double dx, out double dz);
            px += dx;
            pz += dz;
        }

        for (int k = 0; k < x.Length; k++)
        {
            long point = newest - k;
            near = floor.HeightAt(px, near, pz, out Vector3 normal);
            Store(point, new TrackPoint(px, near, pz, normal), steer.CourseAngleAt(1));
            Stride(point - 1, steer, out double dx, out double dz);
            px -= dx;
            pz -= dz;
        }

        HeadPoint = Point(0);
    }

    /// <summary>From a point to the next.</summary>
    private void Stride(long point, in TrackSteering steer, out double dx, out double dz)
    {
        PortableMath.SinCos(steer.HeadingAt((point + 0.5) * Step, 1, Wavelength), out double sine, out double cosine);
        dx = Step * sine;
        dz = Step * cosine;
    }

    /// <summary>Moves the head on along headings that swing about its way.</summary>
    /// <param name="way">Arc length, not negative.</param>
    /// <param name="steer">Where it goes.</param>
    /// <param name="floor">Gives heights.</param>
    public void Advance(double way, TrackSteering steer, in CrawlFloor floor)
    {
        double end = Head + way;
        double done = 0;
        TrackPoint head = HeadPoint;
        while (Head < end)
        {
            // Up to the next point of the grid, or to the end.
            long next = (long)Math.Floor((Head / Step) + 1e-9) + 1;
            double to = Math.Min(end, next * Step);
            double length = to - Head;
            double fraction = (done + (0.5 * length)) / way;
            head = Go(head, length, steer.HeadingAt(0.5 * (Head + to), fraction, Wavelength), floor);
            done += length;
            Head = to;
            if (to >= (next * Step) - (1e-9 * Step))
            {
                Store(next, head, steer.CourseAngleAt(done / way));
            }
        }

        HeadPoint = head;
        Foresee(steer, floor);
    }

    /// <summary>The curve at an arc length between the tail's end and the head.</summary>
    public TrackPoint At(double arc)
    {
        double grid = arc / Step;
        double oldest = newest - x.Length + 2;
        grid = Scalar.Clamp(grid, oldest, newest - 1);
        long i = Math.Min((long)Math.Floor(grid), newest - 2);
        double t = grid - i;
        int a = Slot(i - 1);
        int b = After(a);
        int c = After(b);
        int d = After(c);
        double u = t * t;
        double w0 = 0.5 * ((-t * u) + (2 * u) - t);
        double w1 = 0.5 * ((3 * t * u) - (5 * u) + 2);
        double w2 = 0.5 * ((-3 * t * u) + (4 * u) + t);
        double w3 = 0.5 * ((t * u) - u);
        return new TrackPoint(
            (x[a] * w0) + (x[b] * w1) + (x[c] * w2) + (x[d] * w3),
            (y[a] * w0) + (y[b] * w1) + (y[c] * w2) + (y[d] * w3),
            (z[a] * w0) + (z[b] * w1) + (z[c] * w2) + (z[d] * w3),
            Vec.Lerp(normals[b], normals[c], (float)t));
    }

    /// <summary>The way's heading at an arc length, without the swings of the track.</summary>
    public double CourseAngleAt(double arc)
    {
        double grid = Scalar.Clamp(arc / Step, newest - x.Length + 1, newest - 1);
        long i = (long)Math.Floor(grid);
        int slot = Slot(i);
        return Scalar.Lerp(travel[slot], travel[After(slot)], grid - i);
    }

    /// <summary>Takes the whole track along, turned about the origin and then shifted.</summary>
    public void Carry(double turn, double shiftX, double shiftY, double shiftZ)
    {
        PortableMath.SinCos(turn, out double sine, out double cosine);
        for (int k = 0; k < x.Length; k++)
        {
            double px = x[k];
            double pz = z[k];
            x[k] = (px * cosine) + (pz * sine) + shiftX;
            z[k] = (pz * cosine) - (px * sine) + shiftZ;
            y[k] += shiftY;
            travel[k] += turn;
            Vector3 n = normals[k];
            normals[k] = new Vector3((float)((n.X * cosine) + (n.Z * sine)), n.Y, (float)((n.Z * cosine) - (n.X * sine)));
        }

        TrackPoint h = HeadPoint;
        HeadPoint = new TrackPoint((h.X * cosine) + (h.Z * sine) + shiftX, h.Y + shiftY, (h.Z * cosine) - (h.X * sine) + shiftZ, h.Normal);
    }

    /// <summary>Shifts the whole track over the ground.</summary>
    public void Drift(double shiftX, double shiftZ)
    {
        for (int k = 0; k < x.Length; k++)
        {
            x[k] += shiftX;
            z[k] += shiftZ;
        }

        HeadPoint = new TrackPoint(HeadPoint.X + shiftX, HeadPoint.Y, HeadPoint.Z + shiftZ, HeadPoint.Normal);
    }

    private static TrackPoint Go(in TrackPoint from, double length, double heading, in CrawlFloor floor)
    {
        PortableMath.SinCos(heading, out double sine, out double cosine);

        // On a slope the same way along the body is less way over the map.
        Vector3 n = from.Normal;
        double rise = n.Y > 0.05f ? -((n.X * sine) + (n.Z * cosine)) / n.Y : 0;
        double level = length / Math.Sqrt(1 + (rise * rise));
        double px = from.X + (sine * level);
        double pz = from.Z + (cosine * level);
        double height = floor.HeightAt(px, from.Y, pz, out Vector3 normal);
        return new TrackPoint(px, height, pz, normal);
    }

    /// <summary>The points just ahead of the head, if it goes on as it does.</summary>
    private void Foresee(TrackSteering steer, in CrawlFloor floor)
    {
        TrackPoint point = HeadPoint;
        double arc = Head;
        long last = (long)Math.Floor((Head / Step) + 1e-9);
        for (int k = 1; k <= Ahead; k++)
        {
            double to = (last + k) * Step;
            point = Go(point, to - arc, steer.HeadingAt(0.5 * (arc + to), 1, Wavelength), floor);
            arc = to;
            Store(last + k, point, steer.CourseAngleAt(1));
        }

        newest = last + Ahead;
    }

    private TrackPoint Point(long point)
    {
        int k = Slot(point);
        return new TrackPoint(x[k], y[k], z[k], normals[k]);
    }

    private void Store(long point, in TrackPoint at, double heading)
    {
        int k = Slot(point);
        x[k] = at.X;
        y[k] = at.Y;
        z[k] = at.Z;
        normals[k] = at.Normal;
        travel[k] = heading;
    }

    private int After(int slot) => slot + 1 < x.Length ? slot + 1 : 0;

    private int Slot(long point)
    {
        long k = point % x.Length;
        return (int)(k < 0 ? k + x.Length : k);
    }
}
