using CreatureGen.Blueprints;
using CreatureGen.Repairs;
using CreatureGen.Unity;
using UnityEngine;

namespace CreatureGen.Meadow
{
    /// <summary>A player's creature in the saves: its blueprint as text, which later versions of the library read too.</summary>
    public sealed class CreatureSaves : MonoBehaviour
    {
        [SerializeField] private CreatureBehaviour creature;
        [SerializeField] private string key = "pet";

        public void Save() => PlayerPrefs.SetString(key, BlueprintJson.Write(creature.Creature.Blueprint));

        /// <summary>Shows the saved creature on an object that has none yet.</summary>
        /// <returns>Whether there was one that can be built.</returns>
        public bool Load(CreatureBehaviour into)
        {
            BlueprintReading reading = BlueprintJson.Read(PlayerPrefs.GetString(key, ""));
            if (reading.Blueprint == null)
            {
                Debug.LogWarning("no creature in the save: " + reading.Problems[0]);
                return false;
            }

            into.Show(BlueprintRepair.Repair(reading.Blueprint).Creature);
            return true;
        }
    }
}
