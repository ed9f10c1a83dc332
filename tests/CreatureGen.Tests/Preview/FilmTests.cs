using System;
using System.Linq;
using System.Numerics;
using System.Threading;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Preview.Films;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Scenes;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class FilmTests
{
    private static readonly FilmOptions small = new() { Width = 96, Height = 72 };

    [Theory]
    [InlineData(RequestedKind.Walking, 42, 2, GroundRelief.Flat)]
    [InlineData(RequestedKind.Walking, 42, 1, GroundRelief.Rough, Explicit = true)]
    [InlineData(RequestedKind.Walking, 7, 1, GroundRelief.Rough, Explicit = true)]
    [InlineData(RequestedKind.Flying, 1, 1, GroundRelief.Flat)]
    [InlineData(RequestedKind.Swimming, 4, 1, GroundRelief.Rough, Explicit = true)]
    public void The_moment_after_the_last_is_the_first_again(RequestedKind kind, ulong seed, int movement, GroundRelief ground)
    {
        Film film = Make(kind, seed, movement, small with { Ground = ground });
        Take take = film.Take;
        Assert.Equal(0, film.FrameCount % Take.StripFrames);
        Vector3[] first = take.SkinAt(0).Positions;
        Vector3[] last = take.SkinAt(film.FrameCount * take.MomentsPerFrame).Positions;
        float size = film.RoomSize.Length();
        float next = Farthest(first, take.SkinAt(1).Positions);
        Assert.True(Farthest(first, last) < Math.Max(0.5f * next, 2e-3f * size), $"{Farthest(first, last)} of {size}, moment to moment {next}");
    }

    [Fact(Explicit = true)]
    public void The_ground_is_at_the_end_as_it_was_at_the_beginning_and_moves_between()
    {
        Film film = Make(RequestedKind.Walking, 42, 1, small with { Ground = GroundRelief.Rough });
        int end = film.FrameCount * film.Take.MomentsPerFrame;
        RenderMesh first = film.FloorAt(0)!;
        RenderMesh last = film.FloorAt(end)!;
        RenderMesh middle = film.FloorAt(end / 3)!;
        Assert.NotEqual(first.Positions.ToArray(), middle.Positions.ToArray());
        foreach (int i in Enumerable.Range(0, Math.Min(first.Triangles.Length, last.Triangles.Length) / 3).Where(i => i % 101 == 0))
        {
            // The same pieces of the same colours, but for what is left of a cell of the hills.
            Vector3 a = Centre(first, i);
            int same = Nearest(last, a);
            Assert.True(Vector3.Distance(a, Centre(last, same)) < 0.02f * film.RoomSize.Z);
            Assert.Equal(first.Colours[first.Triangles[3 * i]], last.Colours[last.Triangles[3 * same]]);
        }
    }

    [Fact]
    public void Feet_that_stand_stay_on_their_checks()
    {
        Film film = Make(RequestedKind.Walking, 42, 1, small);
        Take take = film.Take;
        for (int foot = 0; foot < take.Feet; foot++)
        {
            for (int moment = 1; moment < take.StrokeMoments; moment++)
            {
                FootReport before = take.FootAt(moment - 1, foot);
                FootReport now = take.FootAt(moment, foot);
                if (before.Phase == FootPhase.Stance && now.Phase == before.Phase)
                {
                    Assert.Equal(before.Place, now.Place);
                }
            }
        }
    }

    [Fact(Explicit = true)]
    public void Films_and_strips_are_the_same_for_any_number_of_threads()
    {
        Film one = Make(RequestedKind.Swimming, 4, 1, small);
        Film three = Make(RequestedKind.Swimming, 4, 1, small with { Threads = 3 });
        Assert.Equal(one.Strip(TestContext.Current.CancellationToken).Bytes.ToArray(), three.Strip(TestContext.Current.CancellationToken).Bytes.ToArray());
        Assert.Equal(one.Frame(3).Bytes.ToArray(), three.Frame(3).Bytes.ToArray());
        Assert.NotEqual(one.Frame(0).Bytes.ToArray(), one.Frame(3).Bytes.ToArray());
    }

    [Fact]
    public void The_whole_creature_is_in_every_picture()
    {
        Film film = Make(RequestedKind.Walking, 42, 2, small);
        foreach (View view in new[] { View.Side, View.Front, View.ThreeQuarter })
        {
            Camera camera = film.CameraFor(view, 300, 200);
            for (int moment = 0; moment < film.Take.StrokeMoments; moment += 17)
            {
                foreach (Vector3 point in film.Take.SkinAt(moment).Positions)
                {
                    Vector3 pixel = camera.Project(point, 300, 200);
                    Assert.InRange(pixel.X, 0f, 300f);
                    Assert.InRange(pixel.Y, 0f, 200f);
                }
            }
        }
    }

    [Fact(Explicit = true)]
    public void The_diagram_is_filled_as_long_as_feet_stand()
    {
        Film film = Make(RequestedKind.Walking, 42, 1, small);
        Picture strip = film.Strip(TestContext.Current.CancellationToken);
        int moments = film.Take.StrokeMoments;
        for (int foot = 0; foot < film.Take.Feet; foot++)
        {
            Pixel colour = FootName.Colour(film.Profile.Legs!, foot);
            double standing = Enumerable.Range(0, moments).Count(moment => film.Take.FootAt(moment, foot).Phase == FootPhase.Stance) / (double)moments;
            int max = Enumerable.Range(strip.Height - CycleDiagram.Height(film), CycleDiagram.Height(film) - 2).Max(y => Enumerable.Range(0, strip.Width).Count(x => strip[x, y] == colour));
            Assert.Equal(standing, max / (double)(strip.Width - 66), 0.02);
        }
    }

    [Fact]
    public void What_cannot_be_filmed_is_refused()
    {
        var profile = new MotionProfile(PreviewSubjects.Of(1));
        Movement movement = Movement.Of(profile)[1];
        Assert.Throws<ArgumentNullException>(() => new Film(null!, movement, small));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Film(profile, movement, small with { Width = 5 }));
        var film = new Film(profile, movement, small);
        Assert.Throws<ArgumentOutOfRangeException>(() => film.Frame(film.FrameCount));
        Assert.Throws<ArgumentOutOfRangeException>(() => film.Frame(-1));
        Assert.Throws<OperationCanceledException>(() => film.Strip(new CancellationToken(true)));
    }

    private static Film Make(RequestedKind kind, ulong seed, int movement, FilmOptions options)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, SizeOfSeed.In(CreatureOptions.Default with { Kind = kind }, seed)));
        return new Film(profile, Movement.Of(profile)[movement], options);
    }

    private static float Farthest(Vector3[] a, Vector3[] b) => a.Zip(b, Vector3.Distance).Max();

    private static Vector3 Centre(RenderMesh mesh, int triangle) =>
        (mesh.Positions[mesh.Triangles[3 * triangle]] + mesh.Positions[mesh.Triangles[(3 * triangle) + 1]] + mesh.Positions[mesh.Triangles[(3 * triangle) + 2]]) / 3f;

    private static int Nearest(RenderMesh mesh, Vector3 point)
    {
        int nearest = 0;
        for (int i = 1; i < mesh.Triangles.Length / 3; i++)
        {
            nearest = Vector3.Distance(Centre(mesh, i), point) < Vector3.Distance(Centre(mesh, nearest), point) ? i : nearest;
        }

        return nearest;
    }
}
