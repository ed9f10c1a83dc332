using CreatureGen.Creatures;
using CreatureGen.Engines;
using CreatureGen.Motion;
using Godot;

namespace CreatureGen.GodotAddon;

/// <summary>A creature in the scene: grown from its seed when it enters the tree, or from any creature that it is given, and moved each frame of the physics.</summary>
public partial class CreatureNode : Node3D
{
    private Skeleton3D skeleton;
    private System.Numerics.Quaternion[] rotations;
    private System.Numerics.Vector3[] positions;

    [Export] public ulong Seed { get; set; } = 101;

    [Export] public int TextureSize { get; set; } = 512;

    [Export] public uint GroundMask { get; set; } = uint.MaxValue;

    /// <summary>What the creature is asked to do; the library turns it into steps, beats or bends.</summary>
    public MotionInput Input { get; set; }

    public Creature Creature { get; private set; }

    public CreatureAnimator Animator { get; private set; }

    public override void _Ready()
    {
        if (Creature == null)
        {
            Show(CreatureGenerator.Generate(Seed));
            Input = new MotionInput(Creature.DefaultSpeed);
        }
    }

    public override void _PhysicsProcess(double delta)
    {
        Animator.Update((float)delta, Input, new SpaceGround(GetWorld3D().DirectSpaceState, GroundMask));
        Pose();
    }

    /// <summary>Shows a creature where this node stands.</summary>
    public void Show(Creature creature)
    {
        Creature = creature;
        Animator = new CreatureAnimator(creature);
        rotations = new System.Numerics.Quaternion[creature.Skeleton.Count];
        positions = new System.Numerics.Vector3[creature.Skeleton.Count];
        Quaternion q = GlobalBasis.GetRotationQuaternion();
        Animator.Teleport(new RootPlace(GodotSpace.Point(GlobalPosition), new System.Numerics.Quaternion(q.X, q.Y, q.Z, q.W)), FlatGround.Level);
        skeleton = CreatureMeshes.Bones(creature);
        AddChild(skeleton);
        var body = new MeshInstance3D { Mesh = CreatureMeshes.Surface(creature), Skin = CreatureMeshes.Binds(creature), MaterialOverride = CreatureMeshes.Coat(creature, TextureSize) };
        skeleton.AddChild(body);
        body.Skeleton = body.GetPathTo(skeleton);
        Pose();
    }

    /// <summary>Bones are moved as the animator has them, in their parents' space.</summary>
    private void Pose()
    {
        EngineAxes.Godot.Convert(Animator.LocalPose, new Rigging.Pose(rotations, positions));
        for (int bone = 0; bone < rotations.Length; bone++)
        {
            skeleton.SetBonePoseRotation(bone, new Quaternion(rotations[bone].X, rotations[bone].Y, rotations[bone].Z, rotations[bone].W));
            skeleton.SetBonePosePosition(bone, GodotSpace.Point(positions[bone]));
        }

        System.Numerics.Quaternion root = Animator.Root.Rotation;
        GlobalPosition = GodotSpace.Point(Animator.Root.Position);
        GlobalBasis = new Basis(new Quaternion(root.X, root.Y, root.Z, root.W));
    }
}
