using System;
using System.Numerics;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Tests.Preview;

/// <summary>What a ray through a place of the picture meets first, found by trying every triangle.</summary>
/// <param name="Triangle">Index of the triangle, −1 for none.</param>
/// <param name="Colour">Linear RGB there.</param>
/// <param name="Point">Where, model space, metres.</param>
internal readonly record struct RayHit(int Triangle, Vector3 Colour, Vector3 Point)
{
    public static RayHit Through(RenderMesh mesh, Camera camera, double x, double y, int width, int height)
    {
        double tangent = Math.Tan(camera.FieldOfViewDegrees * Math.PI / 360) / (height * 0.5);
        double right = (x - (width * 0.5)) * tangent;
        double up = ((height * 0.5) - y) * tangent;
        double[] ray =
        [
            camera.Forward.X + (camera.Right.X * right) + (camera.Up.X * up),
            camera.Forward.Y + (camera.Right.Y * right) + (camera.Up.Y * up),
            camera.Forward.Z + (camera.Right.Z * right) + (camera.Up.Z * up),
        ];
        var first = new RayHit(-1, Vector3.Zero, Vector3.Zero);
        double nearest = double.PositiveInfinity;
        for (int i = 0; i < mesh.Triangles.Length; i += 3)
        {
            Vector3 a = mesh.Positions[mesh.Triangles[i]];
            double[] ab = Difference(mesh.Positions[mesh.Triangles[i + 1]], a);
            double[] ac = Difference(mesh.Positions[mesh.Triangles[i + 2]], a);
            double[] across = Cross(ray, ac);
            double determinant = Dot(ab, across);
            double[] from = Difference(camera.Eye, a);
            double b = Dot(from, across) / determinant;
            double[] other = Cross(from, ab);
            double c = Dot(ray, other) / determinant;
            double depth = Dot(ac, other) / determinant;
            if (b >= 0 && c >= 0 && b + c <= 1 && depth >= camera.Near && depth < nearest)
            {
                nearest = depth;
                Vector3 colour = (mesh.Colours[mesh.Triangles[i]] * (float)(1 - b - c))
                    + (mesh.Colours[mesh.Triangles[i + 1]] * (float)b)
                    + (mesh.Colours[mesh.Triangles[i + 2]] * (float)c);
                first = new RayHit(i / 3, colour, camera.Eye + (new Vector3((float)ray[0], (float)ray[1], (float)ray[2]) * (float)depth));
            }
        }

        return first;
    }

    private static double[] Difference(Vector3 a, Vector3 b) => [(double)a.X - b.X, (double)a.Y - b.Y, (double)a.Z - b.Z];

    private static double Dot(double[] a, double[] b) => (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]);

    private static double[] Cross(double[] a, double[] b) =>
        [(a[1] * b[2]) - (a[2] * b[1]), (a[2] * b[0]) - (a[0] * b[2]), (a[0] * b[1]) - (a[1] * b[0])];
}
