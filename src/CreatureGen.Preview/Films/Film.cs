using System;
using System.Collections.Generic;
using System.Numerics;
using System.Threading;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Films;

/// <summary>
/// A movement of a creature as a moving picture that loops without a jump, and as a film strip. The camera goes along; what goes on the ground goes on checks that stay where they are, so that
/// a sliding foot would be seen. Pictures may be made in any order and on any threads; they are the same every time.
/// </summary>
public sealed class Film : IFilm
{
    private const int AtlasSize = 512;

    // Side of a check, part of the creature's length.
    private const float CheckPart = 0.11f;

    // Flat pieces along a side of a check, on hills.
    private const int PatchesPerCheck = 4;

    // How far the floor goes beyond the creature, part of its length.
    private const float FloorPart = 0.45f;

    // Every so manieth vertex is looked at to find out how much room the creature takes.
    private const int Sparsely = 5;

    private readonly RenderMesh dressed;
    private readonly CheckedFloor? floor;
    private readonly Vector3[] room;

    /// <summary>Takes the film.</summary>
    /// <param name="profile">The creature's.</param>
    /// <param name="movement">What it does; one of those of the profile, at any speed.</param>
    /// <param name="options">How the film is made.</param>
    /// <exception cref="ArgumentException">An option is out of its range.</exception>
    public Film(MotionProfile profile, Movement movement, FilmOptions options)
    {
        ArgumentNullException.ThrowIfNull(profile);
        ArgumentNullException.ThrowIfNull(movement);
        ArgumentNullException.ThrowIfNull(options);
        CheckRange(options.Width, nameof(options.Width));
        CheckRange(options.Height, nameof(options.Height));
        Profile = profile;
        Movement = movement;
        Options = options;
        Take = new Take(profile, movement, options.Ground);
        RenderMesh bare = RenderMesh.From(profile.Subject.Creature!);
        dressed = options.Shading is ShadingMode.Flat or ShadingMode.Faceted ? bare : bare.WithTextures(CreatureTextures.Bake(profile.Subject.Creature!, AtlasSize));
        room = FindRoom();
        floor = Take.OnGround ? FloorAround(BoundingBox.Of(room)) : null;
    }

    /// <summary>The creature's profile.</summary>
    public MotionProfile Profile { get; }

    /// <summary>What it does.</summary>
    public Movement Movement { get; }

    /// <summary>How the film is made.</summary>
    public FilmOptions Options { get; }

    /// <summary>Frames until everything is as it was: those of one cycle; of several on rough ground; of some beats and a glide of fliers that glide between.</summary>
    public int FrameCount => Take.Frames;

    /// <summary>Seconds of one cycle of the gait, or of one stroke.</summary>
    public float CycleSeconds => Take.StrokeSeconds;

    /// <summary>Metres per second at which the creature goes: what was asked, or as fast as it can.</summary>
    public float Speed => Take.Speed;

    /// <summary>How long a frame shows. Cycles shorter than 16 of the shortest frames, as the beats of small wings, are slowed down.</summary>
    public int MillisecondsPerFrame => Math.Max(ShortestFrame, (int)Math.Round(1000f * Take.FrameSeconds));

    /// <inheritdoc/>
    public IReadOnlyList<ClipEvent> Events => Array.ConvertAll(Take.Events, one => new ClipEvent(one.Time * MillisecondsPerFrame / 1000f, one.Name, one.Joint, one.Strength));

    /// <summary>How much slower than life the film is; 1 in most cases.</summary>
    public float Slowness => Math.Max(1f, MillisecondsPerFrame / (1000f * Take.FrameSeconds));

    internal Take Take { get; }

    /// <summary>Room that the creature takes over a cycle, metres.</summary>
    internal Vector3 RoomSize => BoundingBox.Of(room).Size;

    // Viewers of animated pictures show nothing faster.
    private const int ShortestFrame = 20;

    /// <summary>A frame of the moving picture.</summary>
    /// <param name="index">0 up to <see cref="FrameCount"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    public Picture Frame(int index)
    {
        if ((uint)index >= (uint)FrameCount)
        {
            throw new ArgumentOutOfRangeException(nameof(index), index, FormattableString.Invariant($"expected 0..{FrameCount - 1}"));
        }

        return Draw(index * Take.MomentsPerFrame, CameraFor(Options.View, Options.Width, Options.Height), Options.Width, Options.Height);
    }

    /// <summary>Eight pictures of one cycle from the side and eight from the front, the feet's contacts marked on the ground, and below them when each foot is down; for what does not go on feet, the stroke.</summary>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public Picture Strip(CancellationToken cancellation = default) => FilmStrip.Draw(this, cancellation);

    /// <summary>The camera that sees the whole creature at all times.</summary>
    internal Camera CameraFor(View view, int width, int height) => Camera.Fit(Views.Angle(view), room, width / (float)height);

    /// <summary>The floor as the camera sees it; null where there is none.</summary>
    internal RenderMesh? FloorAt(int moment) => floor?.At(new RootPlace(Take.CameraAt(moment), Quaternion.Identity), RootPlace.Identity);

    /// <summary>The creature on its floor.</summary>
    internal Picture Draw(int moment, Camera camera, int width, int height)
    {
        (Vector3[] positions, Vector3[] normals) = Take.SkinAt(moment);
        RenderMesh mesh = dressed.Posed(positions, normals);
        return Renderer.Render(FloorAt(moment) is RenderMesh below ? mesh.With(below) : mesh, camera, new RenderOptions
        {
            Width = width,
            Height = height,
            Shading = Options.Shading,
            Samples = SampleCount.Four,
            Ground = GroundKind.None,
        });
    }

    private Vector3[] FindRoom()
    {
        var points = new List<Vector3>();
        int all = Take.Frames * Take.MomentsPerFrame;
        for (int i = 0; i < Take.StripFrames; i++)
        {
            // One stroke closely, and all of the film where it is longer.
            Add(i * Take.StrokeMoments / Take.StripFrames);
            if (all > Take.StrokeMoments)
            {
                Add(i * all / Take.StripFrames);
            }
        }

        return [.. points];

        void Add(int moment)
        {
            Vector3[] skin = Take.SkinAt(moment).Positions;
            for (int v = 0; v < skin.Length; v += Sparsely)
            {
                points.Add(skin[v]);
            }
        }
    }

    private CheckedFloor FloorAround(BoundingBox box)
    {
        float length = box.Size.Z;
        float check = CheckPart * length;
        if (Take.Way > 0f)
        {
            // A whole number of pairs of checks, so that they too are as they were at the end.
            check = Take.Way / (2f * (float)Math.Ceiling(Take.Way / (2f * check)));
        }

        float beyond = FloorPart * length;
        float halfWidth = Math.Max(Math.Abs(box.Min.X), Math.Abs(box.Max.X)) + beyond;
        return new CheckedFloor(Take.Surface, check, Options.Ground == GroundRelief.Flat ? 1 : PatchesPerCheck, halfWidth, box.Min.Z - beyond, box.Max.Z + beyond);
    }

    internal static void CheckRange(int value, string name)
    {
        if (value is < 32 or > 4096)
        {
            throw new ArgumentOutOfRangeException(name, value, "expected 32..4096 pixels");
        }
    }
}
