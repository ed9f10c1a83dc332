using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>The inside of a pipe along the X axis, with the origin at its bottom: floor, wall and ceiling in one, and up is towards its axis.</summary>
internal sealed class PipeSurface : CourseSurface
{
    private readonly Vector3 centre;

    /// <summary>Lays a pipe.</summary>
    /// <param name="radius">Metres.</param>
    public PipeSurface(float radius)
        : base(new Pipe(radius))
    {
        Radius = radius;
        centre = new Vector3(0f, radius, 0f);
    }

    /// <summary>Metres.</summary>
    public float Radius { get; }

    public override bool IsLevel => false;

    public override Vector3 UpAt(Vector3 place) => Vec.Normalize(new Vector3(0f, centre.Y - place.Y, centre.Z - place.Z), Vector3.UnitY);

    public override Vector3? Below(Vector3 place) => new Vector3(place.X, centre.Y, centre.Z) - (UpAt(place) * Radius);

    private sealed class Pipe : IGround
    {
        private readonly float radius;

        public Pipe(float radius) => this.radius = radius;

        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            // |o + t d|² = r² across the pipe, from within; what begins outside has hit where it is.
            double y = (double)origin.Y - radius, z = origin.Z;
            double a = ((double)direction.Y * direction.Y) + ((double)direction.Z * direction.Z);
            double b = (y * direction.Y) + (z * direction.Z);
            double c = (y * y) + (z * z) - ((double)radius * radius);
            double t = c >= 0 || a < 1e-12 ? 0 : (-b + Math.Sqrt((b * b) - (a * c))) / a;
            Vector3 point = origin + (direction * (float)t);
            hit = new GroundHit(point, Vec.Normalize(new Vector3(0f, radius - point.Y, -point.Z), Vector3.UnitY));
            return t <= distance && (c >= 0 || a >= 1e-12);
        }
    }
}
