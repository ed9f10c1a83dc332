using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Sampling;
using CreatureGen.Unity;
using UnityEngine;

namespace CreatureGen.Meadow
{
    /// <summary>Puts individuals of one species on the meadow, which wander about.</summary>
    public sealed class CreatureSpawner : MonoBehaviour
    {
        [SerializeField] private CreatureBehaviour prefab;
        [SerializeField] private ulong species = 42;
        [SerializeField] private int count = 8;
        [SerializeField] private float spread = 10f;

        private CreatureBehaviour[] herd;

        private void Start()
        {
            herd = new CreatureBehaviour[count];
            for (int i = 0; i < count; i++)
            {
                float turn = 6.2831853f * i / count;
                Vector3 place = transform.position + (new Vector3(Mathf.Sin(turn), 0f, Mathf.Cos(turn)) * spread);
                herd[i] = Instantiate(prefab, place, Quaternion.identity);
                CreatureOptions options = CreatureOptions.Default with { Kind = RequestedKind.Walking, Individual = (ulong)i };
                herd[i].Show(CreatureGenerator.Generate(species, options));
            }
        }

        private void Update()
        {
            for (int i = 0; i < herd.Length; i++)
            {
                float speed = herd[i].Creature.DefaultSpeed;
                herd[i].Input = new MotionInput(speed, Mathf.Sin((Time.time * 0.3f) + i) * 0.5f);
            }
        }
    }
}
