using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Playback;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>How one clip follows another.</summary>
public enum ClipChange
{
    /// <summary>Both play on, the new one gaining weight (<see cref="CrossFade"/>). A change during a change is inertialised.</summary>
    CrossFaded,

    /// <summary>Only the new one plays; what it differs by from what was shown dies away on top of it (<see cref="Inertialisation"/>).</summary>
    Inertialised,
}

/// <summary>
/// Plays clips on a skeleton: one at a time with changes between them, layers on top, events, and the travel of the root. Each update gives a pose. An update allocates nothing once the list of events is long enough;
/// for one thread at a time.
/// </summary>
public sealed class ClipPlayer
{
    private const int UsualEvents = 16;

    private readonly Skeleton skeleton;
    private readonly int root;
    private readonly List<ClipLayer> layers = new();
    private readonly List<ClipEvent> events = new(UsualEvents);
    private readonly LocalPose shown;
    private readonly LocalPose before;
    private readonly LocalPose sampled;
    private readonly LocalPose reference;
    private readonly InertialOffset[] offsets;
    private PlayingClip playing;
    private PlayingClip leaving;
    private CrossFade fade;
    private float sinceChange;
    private float lastStep;
    private int poses;

    /// <summary>Plays a clip from its beginning.</summary>
    /// <param name="skeleton">Whose joints move.</param>
    /// <param name="clip">The first clip.</param>
    /// <param name="rootJoint">Name of the joint that carries the creature over the ground in clips that travel: its way goes into <see cref="Root"/> and out of the pose. Null for clips in place.</param>
    /// <exception cref="ArgumentNullException">There is no skeleton or no clip.</exception>
    /// <exception cref="ArgumentException">The clip has another number of joints, or there is no such joint.</exception>
    public ClipPlayer(Skeleton skeleton, IClip clip, string? rootJoint = null)
    {
        this.skeleton = skeleton ?? throw new ArgumentNullException(nameof(skeleton));
        root = rootJoint is null ? -1 : skeleton.IndexOf(rootJoint);
        if (rootJoint is not null && root < 0)
        {
            throw new ArgumentException($"no joint is called {rootJoint}; expected one of the skeleton's", nameof(rootJoint));
        }

        shown = new LocalPose(skeleton);
        before = new LocalPose(skeleton);
        sampled = new LocalPose(skeleton);
        reference = new LocalPose(skeleton);
        offsets = new InertialOffset[skeleton.Count];
        playing = Begin(clip, 0f);
    }

    /// <summary>What plays; during a change, what is changed to.</summary>
    public IClip Clip => playing.Cursor.Clip;

    /// <summary>Seconds from the beginning of the clip.</summary>
    public float Time => playing.Cursor.Time;

    /// <summary>The part of the clip that has been played, 0..1.</summary>
    public float Phase => playing.Cursor.Phase;

    /// <summary>Whether a clip that stays at its end has come there.</summary>
    public bool IsFinished => playing.Cursor.IsFinished;

    /// <summary>Seconds of clips for each that passes; below 0 backwards. Default: 1.</summary>
    public float Speed { get; set; } = 1f;

    /// <summary>Layers, the lowest first.</summary>
    public IReadOnlyList<ClipLayer> Layers => layers;

    /// <summary>What happened in the last update: events of the clip and of layers that show, each once whenever it is passed.</summary>
    public IReadOnlyList<ClipEvent> Events => events;

    /// <summary>How far the creature went in the last update: by the travel of its root joint, or by the speed of a clip in place. During a change it goes over from one to the other.</summary>
    public RootDelta Root { get; private set; }

    /// <summary>Changes to another clip.</summary>
    /// <param name="clip">From its beginning.</param>
    /// <param name="seconds">How long the change takes; 0 switches at once.</param>
    /// <param name="change">How.</param>
    /// <exception cref="ArgumentNullException">There is no clip.</exception>
    /// <exception cref="ArgumentException">The clip has another number of joints, or the time is negative or not finite.</exception>
    public void Play(IClip clip, float seconds = 0.25f, ClipChange change = ClipChange.CrossFaded) => Change(Begin(clip, 0f), seconds, change);

    /// <summary>Changes to another clip at the same part of it, as from gait to gait.</summary>
    /// <inheritdoc cref="Play"/>
    public void PlayInPhase(IClip clip, float seconds = 0.25f, ClipChange change = ClipChange.CrossFaded) => Change(Begin(clip, playing.Cursor.Phase), seconds, change);

    /// <summary>Goes to a time of the clip; nothing on the way there happens, and the root does not travel.</summary>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    public void Seek(float time) => playing.Seek(time, root, sampled.Pose);

    /// <summary>Lays a clip on top.</summary>
    /// <param name="clip">As many joints as the skeleton has.</param>
    /// <param name="kind">How it lies on what is below.</param>
    /// <param name="mask">The part of it that shows on each joint, 0..1; empty for all of it on every joint.</param>
    /// <exception cref="ArgumentNullException">There is no clip.</exception>
    /// <exception cref="ArgumentException">The clip or the mask is of another number of joints, or a part is out of its range.</exception>
    public ClipLayer AddLayer(IClip clip, LayerKind kind, ReadOnlySpan<float> mask = default)
    {
        Require(clip);
        if (!mask.IsEmpty && mask.Length != skeleton.Count)
        {
            throw new ArgumentException(FormattableString.Invariant($"a mask of {mask.Length} weights; expected {skeleton.Count}, one per joint, or none"), nameof(mask));
        }

        foreach (float part in mask)
        {
            Finite.RequireWithin(part, 0f, 1f, nameof(mask));
        }

        var layer = new ClipLayer(clip, kind, mask);
        layers.Add(layer);
        return layer;
    }

    /// <summary>Takes a layer off.</summary>
    public void Remove(ClipLayer layer) => layers.Remove(layer);

    /// <summary>Lets time pass and gives the pose.</summary>
    /// <param name="seconds">0 and more.</param>
    /// <param name="local">Receives the pose in the parents' space.</param>
    /// <exception cref="ArgumentException">The time is negative or not finite, a speed is not finite, or the pose is of another number of joints.</exception>
    public void Update(float seconds, in Pose local)
    {
        Finite.RequireStep(seconds);
        local.Require(skeleton);
        events.Clear();
        float step = seconds * Speed;
        ClipPassage passage = playing.Advance(step, root, local, out RootDelta way);
        foreach (ClipEvent one in passage)
        {
            events.Add(one);
        }

        fade.Advance(seconds);
        if (!fade.IsFinished)
        {
            leaving.Advance(step, root, sampled.Pose, out RootDelta old);
            PoseBlend.Mix(sampled.Pose, local, fade.Weight, local);
            way = new RootDelta(Vec.Lerp(old.Shift, way.Shift, fade.Weight), Scalar.Lerp(old.Turn, way.Turn, fade.Weight));
        }

        sinceChange += seconds;
        Inertialisation.Apply(offsets, sinceChange, local);
        before.Take(shown.Pose);
        shown.Take(local);
        poses = Math.Min(poses + 1, 2);
        lastStep = seconds;
        Root = way;
        foreach (ClipLayer layer in layers)
        {
            Lay(layer, seconds, local);
        }
    }

    private void Lay(ClipLayer layer, float seconds, in Pose local)
    {
        if (layer.Weight == 0f)
        {
            return;
        }

        foreach (ClipEvent one in layer.Advance(seconds))
        {
            events.Add(one);
        }

        layer.Clip.Sample(layer.Time, sampled.Pose);
        if (layer.Kind == LayerKind.Covers)
        {
            PoseBlend.Mix(local, sampled.Pose, layer.Weight, layer.Mask, local);
            return;
        }

        layer.Clip.Sample(0f, reference.Pose);
        AdditivePose.Subtract(sampled.Pose, reference.Pose, sampled.Pose);
        AdditivePose.Add(sampled.Pose, layer.Weight, layer.Mask, local);
    }

    private void Change(in PlayingClip next, float seconds, ClipChange change)
    {
        Finite.RequireStep(seconds);
        if (change == ClipChange.CrossFaded && fade.IsFinished)
        {
            leaving = playing;
            fade = new CrossFade(seconds);
        }
        else
        {
            Inertialise(next, seconds);
        }

        playing = next;
    }

    /// <summary>Keeps what is shown, with its velocity, over the new clip.</summary>
    private void Inertialise(PlayingClip next, float seconds)
    {
        fade = default;
        sinceChange = 0f;
        if (poses == 0)
        {
            return;
        }

        float step = poses == 2 ? lastStep : 0f;
        var earlier = new PlayingClip(next.Cursor, root, sampled.Pose);
        earlier.Advance(-step * Speed, root, reference.Pose, out _);
        next.Advance(0f, root, sampled.Pose, out _);
        Inertialisation.Start(shown.Pose, poses == 2 ? before.Pose : shown.Pose, sampled.Pose, step > 0f ? reference.Pose : sampled.Pose, step, seconds, offsets);
    }

    private PlayingClip Begin(IClip clip, float phase)
    {
        Require(clip);
        var cursor = new ClipCursor(clip);
        cursor.SeekPhase(phase);
        return new PlayingClip(cursor, root, sampled.Pose);
    }

    private void Require(IClip clip)
    {
        _ = clip ?? throw new ArgumentNullException(nameof(clip));
        if (clip.Joints != skeleton.Count)
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {clip.Name} has {clip.Joints} joints; expected the {skeleton.Count} of the skeleton"), nameof(clip));
        }
    }
}
