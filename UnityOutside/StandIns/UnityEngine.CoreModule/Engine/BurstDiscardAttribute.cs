namespace Unity.Burst;

/// <summary>Burst leaves out the calls of the method it marks; managed code makes them. In the engine's own assembly.</summary>
[AttributeUsage(AttributeTargets.Method | AttributeTargets.Property)]
public class BurstDiscardAttribute : Attribute { }
