namespace UnityEngine.Scripting;

/// <summary>Keeps a player's build from leaving out what nothing calls by name.</summary>
[AttributeUsage(AttributeTargets.All, Inherited = false)]
public class PreserveAttribute : Attribute { }
