using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Bodies;

public sealed class MouthChartTests
{
    [Theory]
    [InlineData(LocomotionKind.Walking)]
    [InlineData(LocomotionKind.Flying)]
    [InlineData(LocomotionKind.Swimming)]
    public void Neighbouring_faces_inside_a_mouth_share_the_texels_of_their_edge(LocomotionKind kind)
    {
        int shared = 0;
        for (ulong seed = 0; seed < 30; seed++)
        {
            Surface surface = GrownSurface.Grow(BlueprintSampler.Sample(seed, kind)).Surface;
            var places = new Dictionary<(int Chart, int Vertex), Vector2>();
            int[] inside = Enumerable.Range(0, surface.Faces.Length).Where(f => Corners(surface.Faces[f]).Any(v => surface.Addresses[v].Region == SurfaceRegion.Mouth)).ToArray();

            // At the corners of the lips all rows of the chart run together.
            HashSet<int> corners = inside.Where(f => Corners(surface.Faces[f]).Distinct().Count() < 4).SelectMany(f => Corners(surface.Faces[f])).ToHashSet();
            foreach (int f in inside)
            {
                Face face = surface.Faces[f];
                FaceTexcoords t = surface.Texcoords[f];
                foreach ((int vertex, Vector2 place) in Corners(face).Zip([t.A, t.B, t.C, t.D]).Where(corner => !corners.Contains(corner.First)))
                {
                    if (!places.TryAdd((face.Chart, vertex), place))
                    {
                        shared++;
                        Assert.True(Vector2.Distance(place, places[(face.Chart, vertex)]) < 1e-6f, $"{kind} {seed}: vertex {vertex} at {place} and {places[(face.Chart, vertex)]}");
                    }
                }
            }
        }

        Assert.True(shared > 1000, $"{shared} shared");
    }

    private static int[] Corners(Face face) => [face.A, face.B, face.C, face.D];
}
