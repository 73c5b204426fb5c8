namespace UnityEngine;

public class UnityException(string message) : SystemException(message) { }
