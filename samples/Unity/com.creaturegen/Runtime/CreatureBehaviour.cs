using CreatureGen.Creatures;
using CreatureGen.Engines;
using CreatureGen.Motion;
using UnityEngine;

namespace CreatureGen.Unity
{
    /// <summary>A creature in the scene: grown from its seed when the scene begins, or from any creature that it is given, and moved each frame.</summary>
    public sealed class CreatureBehaviour : MonoBehaviour
    {
        [SerializeField] private ulong seed = 101;
        [SerializeField] private Material material;
        [SerializeField] private int textureSize = 512;
        [SerializeField] private LayerMask groundLayers = ~0;

        private Transform[] bones;
        private System.Numerics.Quaternion[] rotations;
        private System.Numerics.Vector3[] positions;
        private IGround ground;

        /// <summary>What the creature is asked to do; the library turns it into steps, beats or bends.</summary>
        public MotionInput Input { get; set; }

        public Creature Creature { get; private set; }

        public CreatureAnimator Animator { get; private set; }

        /// <summary>Shows a creature, at the place of this object.</summary>
        public void Show(Creature creature)
        {
            Creature = creature;
            Animator = new CreatureAnimator(creature);
            ground = new PhysicsGround(groundLayers);
            Animator.Teleport(new RootPlace(UnitySpace.Point(transform.position), UnitySpace.Rotation(transform.rotation)), ground);
            int count = creature.Skeleton.Count;
            rotations = new System.Numerics.Quaternion[count];
            positions = new System.Numerics.Vector3[count];
            bones = new Transform[count];
            for (int joint = 0; joint < count; joint++)
            {
                int parent = creature.Skeleton.Parents[joint];
                bones[joint] = new GameObject(creature.Skeleton.Joints[joint].Name).transform;
                bones[joint].SetParent(parent < 0 ? transform : bones[parent], false);
            }

            SkinnedMeshRenderer skin = gameObject.AddComponent<SkinnedMeshRenderer>();
            skin.sharedMesh = CreatureMeshes.Skinned(creature);
            skin.bones = bones;
            skin.rootBone = bones[0];
            if (material != null)
            {
                var own = new Material(material) { mainTexture = CreatureMeshes.BaseColour(creature, textureSize) };
                var all = new Material[skin.sharedMesh.subMeshCount];
                for (int i = 0; i < all.Length; i++)
                {
                    all[i] = own;
                }

                skin.sharedMaterials = all;
            }

            Pose();
        }

        private void Start()
        {
            if (Creature == null)
            {
                Show(CreatureGenerator.Generate(seed));
                Input = new MotionInput(Creature.DefaultSpeed);
            }
        }

        private void Update()
        {
            Animator.Update(Time.deltaTime, Input, ground);
            Pose();
        }

        /// <summary>Bones are moved as the animator has them, in their parents' space. Nothing is allocated.</summary>
        private void Pose()
        {
            EngineAxes.Unity.Convert(Animator.LocalPose, new Rigging.Pose(rotations, positions));
            for (int joint = 0; joint < bones.Length; joint++)
            {
                var q = rotations[joint];
                var p = positions[joint];
                bones[joint].localRotation = new Quaternion(q.X, q.Y, q.Z, q.W);
                bones[joint].localPosition = new Vector3(p.X, p.Y, p.Z);
            }

            transform.SetPositionAndRotation(UnitySpace.Point(Animator.Root.Position), UnitySpace.Rotation(Animator.Root.Rotation));
        }
    }
}
